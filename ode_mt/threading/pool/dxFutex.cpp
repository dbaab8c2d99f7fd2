#include "threading/pool/dxFutex.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

static_assert(sizeof(dxFutexWord) == 4 && dxFutexWord::is_always_lock_free,
              "the kernel reads the plain word");

void dxFutexWait(dxFutexWord &word, std::uint32_t expected) {
    syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, expected, nullptr, nullptr, 0);
}

bool dxFutexWaitFor(dxFutexWord &word, std::uint32_t expected, int seconds) {
    const timespec most = {seconds, 0};
    return syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, expected, &most, nullptr, 0) == 0 || errno != ETIMEDOUT;
}

void dxFutexWake(dxFutexWord &word, unsigned count) {
    syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, count, nullptr, nullptr, 0);
}
