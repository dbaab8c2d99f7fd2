#include "write_all.h"

#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace bench {

bool writeAll(int file, const std::string &text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = write(file, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

}  // namespace bench
