#include "top/screen.h"

#include <curses.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <stdexcept>

#include "top/frame_text.h"
#include "top/program.h"

namespace top {

namespace {

constexpr int kTitles = 2;      // lines of the table before its rows
constexpr int kDetails = 8;     // lines for the chosen world
constexpr int kMinOutput = 3;   // lines for the program's output

}  // namespace

Screen::Screen() {
    std::setlocale(LC_CTYPE, "");
    if (newterm(nullptr, stdout, stdin) == nullptr) throw std::runtime_error("the terminal is unknown or too simple; --batch prints tables");
    cbreak();
    noecho();
    keypad(stdscr, TRUE);
    curs_set(0);
}

Screen::~Screen() { endwin(); }

int Screen::add(int line, const std::string &text, int attributes) const {
    if (line >= LINES) return line;
    attron(static_cast<attr_t>(attributes));
    mvaddnstr(line, 0, text.c_str(), COLS);
    attroff(static_cast<attr_t>(attributes));
    return line + 1;
}

void Screen::show(const std::string &title, const std::vector<FrameRates> &worlds, const std::string &output) {
    erase();
    m_rows = static_cast<int>(worlds.size());
    m_chosen = std::clamp(m_chosen, 0, std::max(m_rows - 1, 0));
    int line = add(0, title, A_BOLD);
    if (worlds.empty()) {
        line = add(line + 1, kNoWorld);
    } else {
        const std::vector<std::string> table = tableOf(worlds);
        const int room = std::max(1, LINES - line - kTitles - kDetails - kMinOutput);
        const int first = std::max(0, m_chosen - room + 1), last = std::min(m_rows, first + room);
        line = add(line + 1, table[0], A_BOLD);
        for (int row = first; row < last; ++row)
            line = add(line, table[static_cast<std::size_t>(kTitles + row)], row == m_chosen ? A_REVERSE : 0);
        ++line;
        for (const std::string &text : detailsOf(worlds[static_cast<std::size_t>(m_chosen)])) line = add(line, text);
    }
    line = add(line + 1, "Output of the program (" + output + ")", A_BOLD);
    if (line < LINES)
        for (const std::string &text : tailOf(output, static_cast<std::size_t>(LINES - line), static_cast<std::size_t>(COLS)))
            line = add(line, text);
    refresh();
}

bool Screen::readKey(std::chrono::milliseconds most) {
    timeout(static_cast<int>(most.count()));
    switch (getch()) {
        case 'q': return true;
        case KEY_UP: m_chosen = std::max(m_chosen - 1, 0); break;
        case KEY_DOWN: m_chosen = std::min(m_chosen + 1, std::max(m_rows - 1, 0)); break;
        default: break;
    }
    return false;
}

}  // namespace top
