#include "loader/read/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace worlds {

MemoryFile::MemoryFile(const std::string &text) : m_descriptor(::memfd_create("sdf", MFD_CLOEXEC)) {
    const auto fail = [] { return std::system_error(errno, std::generic_category(), "a file in memory"); };
    if (m_descriptor < 0) throw fail();
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(m_descriptor, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const std::system_error error = fail();
            ::close(m_descriptor);
            throw error;
        }
        done += static_cast<std::size_t>(written);
    }
}

MemoryFile::~MemoryFile() { ::close(m_descriptor); }

std::string MemoryFile::name() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

}  // namespace worlds
