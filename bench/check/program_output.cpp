#include "check/program_output.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace check {

namespace {

bool begins(const std::string &line, const char *word) { return line.rfind(word, 0) == 0; }

// The lines of a text but for those of ODE_MT's log, one at a time.
class Lines {
public:
    explicit Lines(const std::string &text) : m_stream(text) {}

    // Empty: there is none left.
    std::optional<std::string> next() {
        std::string line;
        while (std::getline(m_stream, line)) {
            ++m_number;
            if (!begins(line, "ODE_MT ")) return line;
        }
        ++m_number;
        return std::nullopt;
    }
    std::size_t number() const { return m_number; }

private:
    std::istringstream m_stream;
    std::size_t m_number = 0;
};

}  // namespace

void ProgramOutput::append(const char *bytes, std::size_t count) {
    const std::size_t kept = std::min(count, kMaxKept - m_text.size());
    m_text.append(bytes, kept);
    if (kept < count) m_isCut = true;
}

std::string ProgramOutput::lastLines(int count) const {
    std::size_t end = m_text.find_last_not_of('\n');
    if (end == std::string::npos) return "";
    ++end;
    std::size_t start = end;
    while (count-- > 0 && start > 0) {
        const std::size_t found = m_text.rfind('\n', start - 1);
        start = found == std::string::npos ? 0 : found;
    }
    if (m_text[start] == '\n') ++start;
    return m_text.substr(start, end - start);
}

std::optional<LineDifference> firstDifferentLine(const std::string &left, const std::string &right) {
    for (Lines leftLines(left), rightLines(right);;) {
        const auto leftLine = leftLines.next(), rightLine = rightLines.next();
        if (!leftLine && !rightLine) return std::nullopt;
        if (leftLine != rightLine)
            return LineDifference{leftLines.number(), leftLine.value_or("nothing"), rightLine.value_or("nothing")};
    }
}

std::string odeMessages(const std::string &errors) {
    static const std::regex place("\\[[^\\]]*:[0-9]+\\]");
    std::string messages, line;
    for (std::istringstream stream(errors); std::getline(stream, line);)
        if (begins(line, "ODE Message") || begins(line, "ODE Error") || begins(line, "ODE INTERNAL ERROR"))
            messages += std::regex_replace(line, place, "[file:line]") + '\n';
    return messages;
}

}  // namespace check
