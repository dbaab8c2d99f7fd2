#include "dxFutex.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

static_assert(sizeof(dxFutexWord) == 4 && dxFutexWord::is_always_lock_free,
              "the kernel reads the plain word");

void dxFutexWait(dxFutexWord &word, std::uint32_t expected) {
    syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, expected, nullptr, nullptr, 0);
}

void dxFutexWake(dxFutexWord &word, unsigned count) {
    syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, count, nullptr, nullptr, 0);
}
