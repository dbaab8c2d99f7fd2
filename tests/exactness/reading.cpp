#include "reading.h"

#include <cstdio>
#include <cstring>

namespace exactness {

namespace {

double realOf(std::uint64_t bits) {
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

}  // namespace

std::string toString(const Word &word) {
    if (word.kind == Word::Kind::Integer) return std::to_string(static_cast<std::int64_t>(word.bits));
    char text[64];
    std::snprintf(text, sizeof(text), "%.17g (%016llx)", realOf(word.bits),
                  static_cast<unsigned long long>(word.bits));
    return text;
}

}  // namespace exactness
