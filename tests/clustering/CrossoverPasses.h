// The crossover passes by name, as parameters of tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

inline constexpr const char *kPasses[] = {"original", "static", "static-unmerged", "duplication", "decluster"};

inline std::string nameOfPass(const testing::TestParamInfo<const char *> &info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
