// A folder of its own for the files of a test, which goes with it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace small_world {

class TestFolder {
public:
    explicit TestFolder(const std::string &name)
        : m_folder(std::filesystem::path(testing::TempDir()) / (name + "_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(m_folder);
    }
    ~TestFolder() { std::filesystem::remove_all(m_folder); }
    TestFolder(const TestFolder &) = delete;
    TestFolder &operator=(const TestFolder &) = delete;

    std::string path(const std::string &file) const { return m_folder / file; }
    std::string write(const std::string &file, const std::string &text) const {
        std::filesystem::create_directories((m_folder / file).parent_path());
        std::ofstream(m_folder / file, std::ios::binary) << text;
        return path(file);
    }

private:
    std::filesystem::path m_folder;
};

}  // namespace small_world
