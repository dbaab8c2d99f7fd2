// The last lines of a program's output, on a terminal that they do not command.
#include "top/program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace {

class OutputTail : public testing::Test {
protected:
    ~OutputTail() override { std::remove(file.c_str()); }

    std::vector<std::string> tail(const std::string &text, std::size_t count, std::size_t width) {
        std::ofstream(file, std::ios::binary) << text;
        return top::tailOf(file, count, width);
    }

    const std::string file = testing::TempDir() + "output-tail-" + std::to_string(getpid());
};

using Lines = std::vector<std::string>;

TEST_F(OutputTail, HasTheLastLines) {
    EXPECT_EQ(tail("one\ntwo\r\nthree", 2, 80), (Lines{"two", "three"}));
    EXPECT_EQ(tail("one\n", 5, 2), (Lines{"on"}));
    EXPECT_EQ(tail("", 5, 80), Lines());
    EXPECT_EQ(top::tailOf(file + ".missing", 5, 80), Lines());
    const Lines lines = tail(std::string(100000, 'a') + "\nlast\n", 5, 10);
    EXPECT_EQ(lines, (Lines{std::string(10, 'a'), "last"}));
}

TEST_F(OutputTail, HasNothingThatATerminalWouldObey) { EXPECT_EQ(tail("a\tb\x1b[2J\xc3\xa9\x7f", 1, 80), (Lines{"a b?[2J???"})); }

}  // namespace
