// Which sanitizer this build has: a few tests cannot run under one, and say so.
#pragma once

#include <gtest/gtest.h>

#include <string>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ODE_MT_ADDRESS_SANITIZER
#endif
#if __has_feature(thread_sanitizer)
#define ODE_MT_THREAD_SANITIZER
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define ODE_MT_ADDRESS_SANITIZER
#endif
#ifdef __SANITIZE_THREAD__
#define ODE_MT_THREAD_SANITIZER
#endif

#ifdef ODE_MT_ADDRESS_SANITIZER
constexpr bool kAddressSanitizer = true;
#else
constexpr bool kAddressSanitizer = false;
#endif
#ifdef ODE_MT_THREAD_SANITIZER
constexpr bool kThreadSanitizer = true;
#else
constexpr bool kThreadSanitizer = false;
#endif

// The OpenMP runtime is not built for ThreadSanitizer, which then does not see its barriers.
inline void skipIfUnseen(const std::string &manager) {
    if (kThreadSanitizer && manager == "openmp")
        GTEST_SKIP() << "ThreadSanitizer cannot see OpenMP's barriers";
}
