// Software prefetch of cache lines that a loop will need some items later.
//
// A cache line that another core wrote last, and that will be written, should be prefetched for write: a prefetch for
// read makes it shared, and the write then causes a second coherence miss to get ownership.
#pragma once

#include <cstddef>

#include "core/dxCacheLine.h"

namespace dxPrefetch {

// Without the empty statement the compiler takes a function that only prefetches for one without effect, and removes its calls.
inline void line(const void *place) {
    __builtin_prefetch(place);
    __asm__ volatile("" : : "r"(place));
}

// The compiler's own __builtin_prefetch(place, 1) does not emit the instruction unless the target is a newer processor.
// Processors made since 2006 accept it (64-bit Windows has required it since 8.1); on some it does nothing.
inline void lineForWrite(const void *place) {
#if defined(__x86_64__)
    __asm__ volatile("prefetchw %0" : : "m"(*static_cast<const char *>(place)));
#else
    __builtin_prefetch(place, 1);
    __asm__ volatile("" : : "r"(place));
#endif
}

namespace detail {
template <class Prefetch>
void forLines(const void *object, std::size_t bytes, const Prefetch &prefetch) {
    const char *const begin = static_cast<const char *>(object), *const last = begin + bytes - 1;
    for (const char *at = begin; at < last; at += kCacheLine) prefetch(at);
    prefetch(last);
}
}  // namespace detail

inline void lines(const void *object, std::size_t bytes) { detail::forLines(object, bytes, line); }
inline void linesForWrite(const void *object, std::size_t bytes) { detail::forLines(object, bytes, lineForWrite); }

}  // namespace dxPrefetch
