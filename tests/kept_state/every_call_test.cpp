// Every exported function of upstream's, called on live objects in every context, and three frames after it,
// on Debian's libode8 and on ODE_MT: nothing that the library keeps from call to call may have missed the
// call.
#include "child_process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <future>
#include <map>

namespace {

using Variables = std::map<std::string, std::string>;
using Outcomes = std::map<std::string, std::string>;  // hash or ending, by case

std::string fromEnvironment(const char *variable, const char *otherwise) {
    const char *value = std::getenv(variable);
    return value == nullptr ? otherwise : value;
}

// Lines are "function/context/space/place/turn hash"; a process that crashed leaves "... ended by ...".
Outcomes play(Variables variables) {
    const exactness::TemporaryFolder folder;
    const std::string path = folder.file("outcomes");
    const exactness::ChildResult child =
        exactness::runChild({ODE_MT_EVERY_CALL_PROGRAM, "--run", path}, variables);
    EXPECT_TRUE(child.succeeded) << child.ending;
    Outcomes outcomes;
    std::ifstream lines(path);
    for (std::string line; std::getline(lines, line);)
        outcomes[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
    return outcomes;
}

Variables stockLibrary() {
    return {{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_STOCK_LIBRARY_DIR", ODE_MT_STOCK_LIBRARY_DIR)}};
}

const Outcomes &stock() {
    static const Outcomes outcomes = play(stockLibrary());
    return outcomes;
}

void compare(const Outcomes &actual) {
    const Outcomes &expected = stock();
    EXPECT_GT(expected.size(), 2000u);
    EXPECT_EQ(actual.size(), expected.size()) << "a process has crashed, or ended early";
    int different = 0;
    for (const auto &[name, outcome] : expected) {
        const auto found = actual.find(name);
        const std::string other = found == actual.end() ? "nothing" : found->second;
        if (other != outcome && ++different <= 60) {
            ADD_FAILURE() << name << " differs: every_call --show " << name
                          << " on both libraries shows where (" << outcome << ", " << other << ")";
        }
    }
    EXPECT_EQ(different, 0) << "cases differ";
}

void compare(const char *threads, const char *algorithm) {
    compare(play({{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_LIBRARY_DIR", ODE_MT_LIBRARY_DIR)},
                  {"ODE_MT_THREADS", threads},
                  {"ODE_MT_ALGORITHM", algorithm}}));
}

// Both runs at the same time; the second with a pattern in fresh memory.
TEST(EveryCall, isRepeatable) {
    Variables patterned = stockLibrary();
    patterned["MALLOC_PERTURB_"] = "165";
    auto again = std::async(std::launch::async, play, patterned);
    stock();
    compare(again.get());
}

TEST(EveryCall, serial) { compare("0", "auto"); }
TEST(EveryCall, twoThreads) { compare("2", "lcp"); }
TEST(EveryCall, clustered) { compare("2", "decluster"); }

}  // namespace
