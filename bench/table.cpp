#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bench {

std::string numberText(double value) {
    if (!std::isfinite(value)) return "-";
    const int digits = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : value >= 0.1 ? 3 : 4;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string millisecondsText(double seconds) { return numberText(1e3 * seconds); }

namespace {

// Characters of a UTF-8 text: its bytes without continuation bytes (10xxxxxx).
std::size_t width(const std::string &text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded(const std::string &text, std::size_t to, Table::Align align) {
    const std::string blanks(to - std::min(to, width(text)), ' ');
    return align == Table::Align::Left ? text + blanks : blanks + text;
}

}  // namespace

void Table::addRow(std::vector<std::string> cells) {
    cells.resize(m_columns.size());
    m_rows.push_back(std::move(cells));
}

std::string Table::text() const {
    std::vector<std::size_t> widths;
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        titles.push_back(m_columns[i].title);
        widths.push_back(width(titles.back()));
        for (const auto &row : m_rows) widths.back() = std::max(widths.back(), width(row[i]));
    }

    std::string result;
    const auto addLine = [&](const std::vector<std::string> &cells) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i)
            line += (i ? "  " : "") + padded(cells[i], widths[i], m_columns[i].align);
        line.erase(line.find_last_not_of(' ') + 1);
        result += line + "\n";
    };
    addLine(titles);
    std::vector<std::string> rules;
    for (std::size_t columnWidth : widths) rules.emplace_back(columnWidth, '-');
    addLine(rules);
    for (const auto &row : m_rows) addLine(row);
    return result;
}

}  // namespace bench
