// Writes the counts of a build that counts its coverage (ode/coverage.cmake) when the process ends in a way
// in which nothing is written by itself: _exit, as in the children that tests fork, and abort, as after
// dDebug. Part of the library in such a build alone; its functions take precedence over the C library's. Each process
// and each library has counts of its own, which are added to what is in the files.
#include <dlfcn.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>

extern "C" {

void __gcov_dump();

[[noreturn]] __attribute__((visibility("default"))) void _exit(int status) {
    __gcov_dump();
    for (;;) syscall(SYS_exit_group, status);
}

[[noreturn]] __attribute__((visibility("default"))) void _Exit(int status) noexcept { _exit(status); }

[[noreturn]] __attribute__((visibility("default"))) void abort() noexcept {
    __gcov_dump();
    reinterpret_cast<void (*)()>(dlsym(RTLD_NEXT, "abort"))();
    for (;;) syscall(SYS_exit_group, 127);
}

}  // extern "C"
