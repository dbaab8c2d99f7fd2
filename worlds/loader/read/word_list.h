// The words of a long text, one by one and without copies: files of meshes hold millions of numbers.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace worlds {

class WordList {
public:
    explicit WordList(std::string_view text) : m_rest(text) {}

    // Empty behind the last word.
    std::string_view next() {
        constexpr std::string_view blanks = " \t\r\n\v\f";
        const std::size_t begin = m_rest.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return m_rest = {};
        const std::size_t end = m_rest.find_first_of(blanks, begin);
        const std::string_view word = m_rest.substr(begin, end == std::string_view::npos ? end : end - begin);
        m_rest.remove_prefix(begin + word.size());
        return word;
    }

private:
    std::string_view m_rest;
};

// A finite number, as both SDF and the files of meshes write it.
inline std::optional<double> finiteNumber(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double number = 0;
    const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || stopped != word.data() + word.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

inline std::optional<std::int64_t> wholeNumber(std::string_view word) {
    std::int64_t number = 0;
    const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || stopped != word.data() + word.size()) return std::nullopt;
    return number;
}

}  // namespace worlds
