// What was read of one field: words compared bit by bit, and text compared as it is.
//
// A NaN equals every other NaN (contract C2), so all of them are read as the same bits. Nothing else is
// folded: -0.0 differs from +0.0.
#pragma once

#include <ode/common.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace exactness {

struct Word {
    enum class Kind { Real, Integer };
    static constexpr std::uint64_t kNaN = 0x7ff8000000000000;

    Kind kind;
    std::uint64_t bits;  // of a double, or of a two's complement integer

    bool operator==(const Word &other) const { return kind == other.kind && bits == other.bits; }
    bool operator!=(const Word &other) const { return !(*this == other); }
};

inline bool isNaN(const Word &word) { return word.kind == Word::Kind::Real && word.bits == Word::kNaN; }

// "0.1 (3fb999999999999a)" or "42": enough digits to distinguish two doubles, and the bits.
std::string toString(const Word &word);

// Inline: a run of a scenario reads millions of them.
class Reading {
public:
    void real(double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof(bits));
        m_words.push_back({Word::Kind::Real, value == value ? bits : Word::kNaN});
    }
    void reals(const dReal *values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) real(values[i]);
    }
    void integer(std::int64_t value) { m_words.push_back({Word::Kind::Integer, static_cast<std::uint64_t>(value)}); }
    void text(const std::string &text) { m_text = text; }
    void clear() {
        m_words.clear();
        m_text.clear();
    }

    const std::vector<Word> &words() const { return m_words; }
    const std::string &text() const { return m_text; }

private:
    std::vector<Word> m_words;
    std::string m_text;
};

}  // namespace exactness
