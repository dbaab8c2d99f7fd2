#include "top/frame_board.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "settings/dxStatisticsFile.h"

namespace top {

namespace {

// A slot is written in less than a microsecond, unless its writer is interrupted meanwhile.
constexpr int kAttempts = 100;

// -1: none there.
int makeFile(std::string &path) {
    const int file = mkostemp(path.data(), O_CLOEXEC);
    if (file < 0) return -1;
    if (posix_fallocate(file, 0, sizeof(dxStatisticsFile)) == 0) return file;
    close(file);
    unlink(path.c_str());
    return -1;
}

bool readWhole(const dxStatisticsSlot &slot, dODE_MT_WorldStatistics &statistics) {
    for (int i = 0; i < kAttempts; ++i)
        if (slot.read(statistics)) return true;
    return false;
}

bool isAlive(std::uint32_t process) { return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM; }

}  // namespace

FrameBoard::FrameBoard(const std::string &folder) : m_path("/dev/shm/odemt_top_XXXXXX") {
    int file = makeFile(m_path);
    if (file < 0) {
        m_path = folder + "/frames_XXXXXX";
        file = makeFile(m_path);
    }
    if (file < 0) throw std::runtime_error("cannot make a file like " + m_path + ": " + std::strerror(errno));
    void *const memory = mmap(nullptr, sizeof(dxStatisticsFile), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    const int error = errno;
    close(file);
    if (memory == MAP_FAILED) {
        unlink(m_path.c_str());
        throw std::runtime_error("cannot map " + m_path + " into memory: " + std::strerror(error));
    }
    m_file = static_cast<dxStatisticsFile *>(memory);
    m_file->slotBytes = sizeof(dxStatisticsSlot);
    m_file->slotCount = dxStatisticsFile::kSlots;
    m_file->magic = dxStatisticsFile::kMagic;
}

FrameBoard::~FrameBoard() {
    munmap(m_file, sizeof *m_file);
    unlink(m_path.c_str());
}

std::vector<WorldFrames> FrameBoard::read() const {
    std::vector<WorldFrames> worlds;
    for (unsigned i = 0; i < dxStatisticsFile::kSlots; ++i) {
        const dxStatisticsSlot &slot = m_file->slots[i];
        const std::uint32_t process = slot.owner.load(std::memory_order_acquire);
        WorldFrames world{i, process, slot.hasEnded.load(std::memory_order_relaxed) != 0, {}};
        if (process == 0 || !readWhole(slot, world.statistics) || world.statistics.frames == 0) continue;
        world.hasEnded = world.hasEnded || !isAlive(process);
        worlds.push_back(world);
    }
    return worlds;
}

std::uint64_t FrameBoard::refused() const { return m_file->refused.load(std::memory_order_relaxed); }

}  // namespace top
