// Whether this build runs under ThreadSanitizer, which
//  - cannot see how the OpenMP runtime synchronises its threads, so that all its reports would be false;
//  - cannot start threads in a child that was forked from a process with threads.
#pragma once

#if defined(__SANITIZE_THREAD__)
constexpr bool underThreadSanitizer = true;
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
constexpr bool underThreadSanitizer = true;
#else
constexpr bool underThreadSanitizer = false;
#endif
#else
constexpr bool underThreadSanitizer = false;
#endif
