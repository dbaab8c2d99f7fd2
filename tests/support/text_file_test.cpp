// Files that can be opened and not read: a read that fails is no exception of the stream's, and names the file.
#include "support/text_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/process.h"
#include "support/temporary_folder.h"

namespace {

const std::string kNoMemory = "/proc/self/mem";  // nothing is mapped at address 0

TEST(TextFile, WhatCannotBeReadIsNamedWithTheReason) {
    for (const auto &[file, reason] :
         {std::pair<std::string, std::string>{kNoMemory, "Input/output error"}, {"/none", "No such file or directory"}, {"/", "is a folder"}}) {
        try {
            support::readTextFile(file);
            ADD_FAILURE() << file;
        } catch (const std::runtime_error &error) {
            EXPECT_EQ(std::string(error.what()), file + ": " + reason);
        }
    }
    EXPECT_EQ(support::readTextFile("/dev/null"), "");
}

TEST(TextFile, OfWhatCannotBeReadNothingIsThere) {
    for (const std::string &file : {kNoMemory, std::string("/none"), std::string("/")}) EXPECT_EQ(support::readWhatIsThere(file), "") << file;
    EXPECT_EQ(support::readWhatIsThere("/proc/self/comm"), support::readTextFile("/proc/self/comm"));
    EXPECT_NE(support::readWhatIsThere("/proc/self/comm"), "");
}

TEST(TextFile, IsWrittenWithItsFolder) {
    const support::TemporaryFolder folder;
    const std::string file = folder.file("a/b/c");
    support::writeTextFile(file, "text");
    EXPECT_EQ(support::readTextFile(file), "text");
    EXPECT_THROW(support::writeTextFile(folder.file("a"), "text"), std::runtime_error);
}

TEST(TextFile, AllIsWrittenToADescriptor) {
    const support::MemoryFile file;
    EXPECT_TRUE(support::writeAll(file.descriptor(), std::string(100'000, 'x')));
    EXPECT_EQ(file.size(), 100'000u);
    EXPECT_FALSE(support::writeAll(-1, "x"));
}

}  // namespace
