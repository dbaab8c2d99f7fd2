#include "reading.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace exactness {

namespace {

constexpr std::uint64_t theNan = 0x7ff8000000000000;

std::uint64_t bitsOf(double value) {
    if (std::isnan(value)) return theNan;
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

double realOf(std::uint64_t bits) {
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

}  // namespace

bool isNaN(const Word &word) { return word.kind == Word::Kind::Real && word.bits == theNan; }

std::string toString(const Word &word) {
    if (word.kind == Word::Kind::Integer) return std::to_string(static_cast<std::int64_t>(word.bits));
    char text[64];
    std::snprintf(text, sizeof(text), "%.17g (%016llx)", realOf(word.bits),
                  static_cast<unsigned long long>(word.bits));
    return text;
}

void Reading::real(double value) { m_words.push_back({Word::Kind::Real, bitsOf(value)}); }

void Reading::reals(const dReal *values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) real(values[i]);
}

void Reading::integer(std::int64_t value) {
    m_words.push_back({Word::Kind::Integer, static_cast<std::uint64_t>(value)});
}

void Reading::clear() {
    m_words.clear();
    m_text.clear();
}

}  // namespace exactness
