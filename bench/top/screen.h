// The terminal while a program runs: a table of its worlds, what there is to say of one, and the last lines that the program has printed.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "top/frame_rates.h"

namespace top {

class Screen {
public:
    // Throws std::runtime_error if the terminal cannot do it.
    Screen();
    ~Screen();  // the terminal is as it was before
    Screen(const Screen &) = delete;
    Screen &operator=(const Screen &) = delete;

    void show(const std::string &title, const std::vector<FrameRates> &worlds, const std::string &output);

    // Waits for a key. Returns whether it was one that ends the program; others are obeyed here.
    bool readKey(std::chrono::milliseconds most);

private:
    // Returns the next line. What does not fit is left out.
    int add(int line, const std::string &text, int attributes = 0) const;

    int m_chosen = 0;  // row
    int m_rows = 0;
};

}  // namespace top
