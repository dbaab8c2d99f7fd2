#include "failing_memory.h"

#include <execinfo.h>
#include <ode/ode.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

// glibc's own, behind the names that are taken over here.
extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *block, std::size_t size);
void *__libc_memalign(std::size_t alignment, std::size_t size);
}

namespace faults {

namespace {

constexpr int kNoSource = -1;

std::atomic<int> armedSource{kNoSource};
std::atomic<long> requests{0}, firstRefused{0};
std::atomic<bool> isLasting{false}, showsStack{false};

void showStack() {
    void *frames[64];
    backtrace_symbols_fd(frames, backtrace(frames, 64), STDERR_FILENO);
}

bool isRefused(Source source) {
    if (armedSource.load(std::memory_order_relaxed) != static_cast<int>(source)) return false;
    const long number = requests.fetch_add(1, std::memory_order_relaxed),
               first = firstRefused.load(std::memory_order_relaxed);
    if (number == first && showsStack.load(std::memory_order_relaxed)) showStack();
    return isLasting.load(std::memory_order_relaxed) ? number >= first : number == first;
}

// The program's, as long as it is armed. Blocks are malloc's, as those that upstream takes otherwise.
void *allocate(std::size_t size) { return isRefused(Source::allocator) ? nullptr : std::malloc(size); }

void *orThrow(void *block) {
    if (block == nullptr) throw std::bad_alloc();
    return block;
}

}  // namespace

void arm(Source source, long first, Shortage shortage) {
    requests = 0;
    firstRefused = first;
    isLasting = shortage == Shortage::lasting;
    armedSource = static_cast<int>(source);
    if (source == Source::allocator) dSetAllocHandler(allocate);
}

void showFirstRefusal() {
    void *frame;
    backtrace(&frame, 1);  // loads what it needs, for which it takes memory
    showsStack = true;
}

long disarm() {
    if (armedSource.exchange(kNoSource) == static_cast<int>(Source::allocator)) dSetAllocHandler(nullptr);
    return requests;
}

}  // namespace faults

// The other forms of operator new call one of these two; operator delete calls free.
void *operator new(std::size_t size) {
    if (faults::isRefused(faults::Source::operatorNew)) throw std::bad_alloc();
    return faults::orThrow(__libc_malloc(size != 0 ? size : 1));
}

void *operator new(std::size_t size, std::align_val_t alignment) {
    if (faults::isRefused(faults::Source::operatorNew)) throw std::bad_alloc();
    return faults::orThrow(__libc_memalign(static_cast<std::size_t>(alignment), size != 0 ? size : 1));
}

// Replaced together with operator new. All blocks are glibc's.
void operator delete(void *block) noexcept { std::free(block); }
void operator delete(void *block, std::size_t) noexcept { std::free(block); }
void operator delete(void *block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void *block, std::size_t, std::align_val_t) noexcept { std::free(block); }

extern "C" {

void *malloc(std::size_t size) {
    if (!faults::isRefused(faults::Source::malloc)) return __libc_malloc(size);
    errno = ENOMEM;
    return nullptr;
}

void *calloc(std::size_t count, std::size_t size) {
    if (!faults::isRefused(faults::Source::malloc)) return __libc_calloc(count, size);
    errno = ENOMEM;
    return nullptr;
}

void *realloc(void *block, std::size_t size) {
    if (!faults::isRefused(faults::Source::malloc)) return __libc_realloc(block, size);
    errno = ENOMEM;
    return nullptr;
}
}
