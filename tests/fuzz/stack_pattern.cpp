#include "stack_pattern.h"

#include <cstring>

namespace fuzz {

namespace {

constexpr unsigned kSize = 128u << 10;

}  // namespace

__attribute__((noinline)) void fillStackBelow(std::uint8_t byte) {
    char frame[kSize];
    std::memset(frame, byte, sizeof frame);
    asm volatile("" : : "r"(frame) : "memory");  // it counts as read, and is written therefore
}

}  // namespace fuzz
