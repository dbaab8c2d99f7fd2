// The name of one of this process's threads, as the system knows it.
//
// Threading: any thread.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

constexpr std::size_t kThreadNameSize = 16;  // the kernel's limit, the end included

// Returns false if the system does not tell. Throws std::bad_alloc.
inline bool dxReadThreadName(std::uint32_t thread, std::string &name) {
    char path[64], line[kThreadNameSize + 1] = "";
    std::snprintf(path, sizeof path, "/proc/self/task/%u/comm", thread);
    std::FILE *const file = std::fopen(path, "re");
    if (file == nullptr) return false;
    const std::size_t length = std::fread(line, 1, kThreadNameSize, file);
    std::fclose(file);
    name.assign(line, length);
    if (!name.empty() && name.back() == '\n') name.pop_back();
    return true;
}
