// Text in aligned columns, and figures as text for people.
#pragma once

#include <string>
#include <vector>

namespace bench {

// Three significant digits, but never more than four behind the point; "-" if it is not finite.
std::string numberText(double value);

std::string millisecondsText(double seconds);

class Table {
public:
    enum class Align { Left, Right };

    struct Column {
        std::string title;
        Align align = Align::Right;
    };

    explicit Table(std::vector<Column> columns) : m_columns(std::move(columns)) {}

    // One cell for each column; missing cells are empty.
    void addRow(std::vector<std::string> cells);

    // Titles, a rule, the rows; two spaces between columns, none at the end of a line.
    std::string text() const;

private:
    std::vector<Column> m_columns;
    std::vector<std::vector<std::string>> m_rows;
};

}  // namespace bench
