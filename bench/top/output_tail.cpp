#include "top/output_tail.h"

#include <algorithm>
#include <fstream>

namespace top {

namespace {

constexpr std::streamoff kBytes = 16384;

// ASCII alone: the width of anything else is the terminal's affair.
char shown(char c) {
    if (c == '\t') return ' ';
    return c >= 0x20 && c < 0x7f ? c : '?';
}

}  // namespace

std::vector<std::string> tailOf(const std::string &file, std::size_t count, std::size_t width) {
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(0, std::ios::end);
    stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - kBytes));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        line.resize(std::min(line.size(), width));
        std::transform(line.begin(), line.end(), line.begin(), shown);
        lines.push_back(line);
    }
    if (lines.size() > count) lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(count));
    return lines;
}

}  // namespace top
