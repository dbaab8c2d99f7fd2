#include "record_file.h"

#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace observer {

namespace {

constexpr std::uint64_t kChunkSteps = 8192;
constexpr std::uint64_t kChunkBytes = kChunkSteps * sizeof(check::Step);
static_assert(kChunkBytes % check::kHeaderBytes == 0, "pages");

// The variable's value when the observer was loaded; the program may change its environment. Lives as long as the process.
const std::string &folder() {
    static const auto *const folder = [] {
        const char *const text = std::getenv(check::kFolderVariable);
        return new std::string(text != nullptr ? text : "");
    }();
    return *folder;
}

// Empty: there is no folder.
std::string fileNamed(const char *name) { return folder().empty() ? "" : folder() + '/' + name; }

std::string numbered(const char *kind, std::uint32_t number) {
    char name[32];
    std::snprintf(name, sizeof name, "%s-%04u", kind, number);
    return fileNamed(name);
}

std::string programFile() {
    char path[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : "";
}

// Null: there is no room.
void *mapGrown(int file, std::uint64_t offset, std::uint64_t bytes) {
    if (file < 0 || posix_fallocate(file, static_cast<off_t>(offset), static_cast<off_t>(bytes)) != 0) return nullptr;
    void *const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, static_cast<off_t>(offset));
    return memory != MAP_FAILED ? memory : nullptr;
}

template <std::size_t Size>
void copyText(char (&to)[Size], const std::string &text) {
    to[text.copy(to, Size - 1)] = '\0';
}

void append(const std::string &path, const void *bytes, std::size_t size) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) return;
    for (const char *next = static_cast<const char *>(bytes); size > 0;) {
        const ssize_t count = ::write(file, next, size);
        if (count < 0 && errno != EINTR) break;
        if (count > 0) next += count, size -= static_cast<std::size_t>(count);
    }
    close(file);
}

}  // namespace

void RecordFile::open(const OdeLibrary &library) {
    if (m_isOpen) return;
    m_isOpen = true;
    int file = -1;
    for (m_number = 0; !folder().empty(); ++m_number) {
        m_path = numbered("record", m_number);
        file = ::open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (file >= 0 || errno != EEXIST) break;
    }
    m_header = static_cast<check::ProcessHeader *>(mapGrown(file, 0, check::kHeaderBytes));
    if (file >= 0) close(file);
    if (m_header == nullptr) return;
    m_header->parent = m_parent;
    m_header->isOurs = library.isOurs;
    m_header->isDouble = library.isDouble;
    copyText(m_header->library, library.file);
    copyText(m_header->program, programFile());
    m_header->magic = check::kMagic;
}

void RecordFile::setHasOneMaker(bool hasOneMaker) {
    if (m_header != nullptr) m_header->hasOneMaker = hasOneMaker;
}

void RecordFile::mapNext() {
    if (m_chunk != nullptr) munmap(m_chunk, kChunkBytes);
    const int file = ::open(m_path.c_str(), O_RDWR | O_CLOEXEC);
    m_chunk = static_cast<check::Step *>(mapGrown(file, check::kHeaderBytes + m_chunks * kChunkBytes, kChunkBytes));
    if (file >= 0) close(file);
    if (m_chunk == nullptr) {
        m_header->isFull = 1;
        return;
    }
    ++m_chunks;
    m_left = kChunkSteps;
}

void RecordFile::write(const check::Step &step) {
    if (m_header == nullptr || m_header->isFull != 0) return;
    if (m_left == 0) mapNext();
    if (m_chunk == nullptr) return;
    m_chunk[kChunkSteps - m_left] = step;
    --m_left;
    ++m_header->steps;
}

void RecordFile::writeStates(const std::vector<unsigned char> &states) {
    if (m_header != nullptr) append(numbered("states", m_number), states.data(), states.size());
}

void RecordFile::addTimes(std::chrono::nanoseconds step, std::chrono::nanoseconds observer) {
    if (m_header == nullptr) return;
    m_header->stepNanoseconds += static_cast<std::uint64_t>(step.count());
    m_header->observerNanoseconds += static_cast<std::uint64_t>(observer.count());
}

void RecordFile::leaveToParent() {
    if (m_header != nullptr) munmap(m_header, check::kHeaderBytes);
    if (m_chunk != nullptr) munmap(m_chunk, kChunkBytes);
    const std::uint32_t parent = m_number;
    *this = RecordFile();
    m_parent = parent;
}

void markLoaded() {
    const std::string path = fileNamed("loaded");
    if (path.empty() || access(path.c_str(), F_OK) == 0) return;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (file >= 0) close(file);
}

void listObjects() {
    const std::string path = fileNamed("objects");
    if (path.empty()) return;
    std::string list = programFile() + '\n';
    dl_iterate_phdr(
        [](dl_phdr_info *info, std::size_t, void *text) {
            if (info->dlpi_name[0] == '/') *static_cast<std::string *>(text) += std::string(info->dlpi_name) + '\n';
            return 0;
        },
        &list);
    append(path, list.data(), list.size());
}

}  // namespace observer
