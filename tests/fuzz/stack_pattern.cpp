#include "stack_pattern.h"

#include <cstring>

namespace fuzz {

namespace {

constexpr int kByte = 0x7f;  // doubles of these are huge, but finite
constexpr unsigned kSize = 128u << 10;

}  // namespace

__attribute__((noinline)) void fillStackBelow() {
    char frame[kSize];
    std::memset(frame, kByte, sizeof frame);
    asm volatile("" : : "r"(frame) : "memory");  // it counts as read, and is written therefore
}

}  // namespace fuzz
