#include "standard_error.h"

#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace exactness {

StandardError::StandardError() : m_file(-1) {
    struct stat status;
    const bool isFile = fstat(STDERR_FILENO, &status) == 0 && S_ISREG(status.st_mode);
    if (!isFile) return;
    m_read = status.st_size;
    m_file = open("/proc/self/fd/2", O_RDONLY | O_CLOEXEC);
}

StandardError::~StandardError() {
    if (m_file >= 0) close(m_file);
}

std::string StandardError::takeNew() {
    std::string text;
    if (m_file < 0) return text;
    std::fflush(stderr);
    char buffer[4096];
    for (ssize_t n; (n = pread(m_file, buffer, sizeof(buffer), m_read)) > 0; m_read += n) {
        text.append(buffer, static_cast<std::size_t>(n));
    }
    return text;
}

}  // namespace exactness
