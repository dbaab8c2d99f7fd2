#include "settings/dxStatisticsFile.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/dxEnvironment.h"

namespace {

// Returns null, and sets errno, if it cannot be mapped. Allocates all of it on the disk, as writing to memory without disk space would end the
// process.
dxStatisticsFile *map(const char *path) {
    const int number = ::open(path, O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (number < 0) return nullptr;
    struct stat state {};
    void *memory = MAP_FAILED;
    int error = EINVAL;
    if (fstat(number, &state) == 0 && S_ISREG(state.st_mode) && state.st_size == sizeof(dxStatisticsFile)) {
        error = posix_fallocate(number, 0, sizeof(dxStatisticsFile));
        if (error == 0) {
            memory = mmap(nullptr, sizeof(dxStatisticsFile), PROT_READ | PROT_WRITE, MAP_SHARED, number, 0);
            error = memory == MAP_FAILED ? errno : 0;
        }
    }
    ::close(number);
    if (error == 0 && !static_cast<dxStatisticsFile *>(memory)->isOfThisVersion()) {
        munmap(memory, sizeof(dxStatisticsFile));
        error = EINVAL;
    }
    errno = error;
    return error == 0 ? static_cast<dxStatisticsFile *>(memory) : nullptr;
}

bool take(dxStatisticsSlot &slot, std::uint32_t process) {
    std::uint32_t free = 0;
    return slot.owner.compare_exchange_strong(free, process, std::memory_order_acq_rel);
}

bool takeEnded(dxStatisticsSlot &slot, std::uint32_t process) {
    std::uint32_t ended = 1;
    if (!slot.hasEnded.compare_exchange_strong(ended, 0, std::memory_order_acq_rel)) return false;
    slot.owner.store(process, std::memory_order_release);
    return true;
}

}  // namespace

void dxStatisticsSharing::open() {
    m_isOpened = true;
    const char *const path = dxEnvironment(dxVariable::Statistics);
    if (path == nullptr) return;
    m_file = map(path);
    if (m_file != nullptr) return;
    std::snprintf(m_complaint, sizeof m_complaint, "ODE_MT_STATISTICS is '%.200s', which cannot be used: %s", path,
                  errno == EINVAL ? "it is no file of this version's odemt_top" : std::strerror(errno));
    m_hasComplaint = true;
}

dxStatisticsSlot *dxStatisticsSharing::claim() {
    if (!m_isOpened) open();
    if (m_file == nullptr) return nullptr;
    const auto process = static_cast<std::uint32_t>(getpid());
    for (dxStatisticsSlot &slot : m_file->slots)
        if (take(slot, process)) return &slot;
    for (dxStatisticsSlot &slot : m_file->slots)
        if (takeEnded(slot, process)) return &slot;
    m_file->refused.fetch_add(1, std::memory_order_relaxed);
    return nullptr;
}

void dxStatisticsSharing::giveBack(dxStatisticsSlot *slot) {
    if (slot != nullptr) slot->hasEnded.store(1, std::memory_order_release);
}

const char *dxStatisticsSharing::takeComplaint() {
    const bool isNew = m_hasComplaint;
    m_hasComplaint = false;
    return isNew ? m_complaint : "";
}

void dxStatisticsSharing::close() {
    if (m_file != nullptr) munmap(m_file, sizeof *m_file);
    m_file = nullptr;
    m_isOpened = true;
}
