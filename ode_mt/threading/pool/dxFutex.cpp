#include "threading/pool/dxFutex.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

static_assert(sizeof(dxFutexWord) == 4 && dxFutexWord::is_always_lock_free, "the kernel reads the plain word");

namespace {

// Returns 0 or the error. errno is unchanged.
int call(dxFutexWord &word, int operation, std::uint32_t value, const timespec *timeout = nullptr) {
    const int before = errno;
    const int error = syscall(SYS_futex, &word, operation, value, timeout, nullptr, 0) < 0 ? errno : 0;
    errno = before;
    return error;
}

}  // namespace

void dxFutexWait(dxFutexWord &word, std::uint32_t expected) { call(word, FUTEX_WAIT_PRIVATE, expected); }

bool dxFutexWaitFor(dxFutexWord &word, std::uint32_t expected, std::chrono::nanoseconds most) {
    const std::chrono::seconds seconds = std::chrono::duration_cast<std::chrono::seconds>(most);
    const timespec timeout = {seconds.count(), (most - seconds).count()};
    return call(word, FUTEX_WAIT_PRIVATE, expected, &timeout) != ETIMEDOUT;
}

void dxFutexWake(dxFutexWord &word, unsigned count) { call(word, FUTEX_WAKE_PRIVATE, count); }
