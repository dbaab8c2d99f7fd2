// What a program has printed, on one of its two streams: kept as far as there is room, compared line by line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace check {

class ProgramOutput {
public:
    static constexpr std::size_t kMaxKept = std::size_t{16} << 20;  // bytes

    void append(const char *bytes, std::size_t count);

    const std::string &text() const { return m_text; }
    bool isCut() const { return m_isCut; }
    std::string lastLines(int count) const;

private:
    std::string m_text;
    bool m_isCut = false;
};

struct LineDifference {
    std::size_t line;         // of the first text, from 1
    std::string left, right;  // "nothing" behind the last line
};

// Lines in which ODE_MT reports what it does ("ODE_MT info: ...") are left out. Empty: there is none.
std::optional<LineDifference> firstDifferentLine(const std::string &left, const std::string &right);

// ODE's own messages and errors, a line each, without the places in the library's source.
std::string odeMessages(const std::string &errors);

}  // namespace check
