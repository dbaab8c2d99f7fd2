#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/text_file.h"

namespace fs = std::filesystem;
using support::TemporaryFolder;

TEST(TemporaryFolder, GoesWithItsContents) {
    fs::path path;
    {
        const TemporaryFolder folder("odemt_test");
        path = folder.path();
        EXPECT_EQ(path.filename().string().rfind("odemt_test_", 0), 0u);
        EXPECT_EQ(folder.write("a/b", "text"), folder.file("a/b"));
        EXPECT_EQ(support::readTextFile(folder.file("a/b")), "text");
        EXPECT_NE(TemporaryFolder().path(), path);
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryFolder, CanBeEmptied) {
    const TemporaryFolder folder;
    folder.write("a/b", "");
    folder.write("c", "");
    folder.empty();
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(TemporaryFolder, HasNoSeparatorOfPathsInItsName) {
    const TemporaryFolder odd;
    fs::create_directory(odd.path() / "a:b");
    setenv("TMPDIR", (odd.path() / "a:b").c_str(), 1);
    const TemporaryFolder folder;
    EXPECT_EQ(folder.path().string().find(':'), std::string::npos);
    unsetenv("TMPDIR");
}

TEST(TemporaryFolder, OneThatCannotBeMadeIsNamed) {
    try {
        const TemporaryFolder folder("no/such/name");
        FAIL();
    } catch (const std::runtime_error &error) {
        EXPECT_NE(std::string(error.what()).find("no/such/name"), std::string::npos);
    }
}
