// Files that can be opened and not read: a read that fails is no exception of the stream's, and names the file.
#include "text_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

const std::string kNoMemory = "/proc/self/mem";  // nothing is mapped at address 0

TEST(TextFile, WhatCannotBeReadIsNamedWithTheReason) {
    for (const auto &[file, reason] : {std::pair<std::string, std::string>{kNoMemory, "Input/output error"}, {"/none", "No such file or directory"}, {"/", "is a folder"}}) {
        try {
            bench::readTextFile(file);
            ADD_FAILURE() << file;
        } catch (const std::runtime_error &error) {
            EXPECT_EQ(std::string(error.what()), file + ": " + reason);
        }
    }
    EXPECT_EQ(bench::readTextFile("/dev/null"), "");
}

TEST(TextFile, OfWhatCannotBeReadNothingIsThere) {
    for (const std::string &file : {kNoMemory, std::string("/none"), std::string("/")}) EXPECT_EQ(bench::readWhatIsThere(file), "") << file;
    EXPECT_EQ(bench::readWhatIsThere("/proc/self/comm"), bench::readTextFile("/proc/self/comm"));
    EXPECT_NE(bench::readWhatIsThere("/proc/self/comm"), "");
}

}  // namespace
