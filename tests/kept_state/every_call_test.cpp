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

const Outcomes &stock() {
    static const Outcomes outcomes =
        play({{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_STOCK_LIBRARY_DIR", ODE_MT_STOCK_LIBRARY_DIR)}});
    return outcomes;
}

void compare(const char *threads, const char *algorithm) {
    const Variables variables{{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_LIBRARY_DIR", ODE_MT_LIBRARY_DIR)},
                              {"ODE_MT_THREADS", threads},
                              {"ODE_MT_ALGORITHM", algorithm}};
    auto running = std::async(std::launch::async, play, variables);
    const Outcomes &expected = stock();
    const Outcomes actual = running.get();
    EXPECT_GT(expected.size(), 3000u);
    EXPECT_EQ(actual.size(), expected.size()) << "a process has crashed, or ended early";
    int shown = 0;
    for (const auto &[name, outcome] : expected) {
        const auto found = actual.find(name);
        const std::string other = found == actual.end() ? "nothing" : found->second;
        if (other != outcome && ++shown <= 60) {
            ADD_FAILURE() << name << " differs: every_call --show " << name
                          << " on both libraries shows where (" << outcome << ", " << other << ")";
        }
    }
    EXPECT_EQ(shown, 0) << "cases differ";
}

TEST(EveryCall, isRepeatable) {
    const Outcomes again =
        play({{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_STOCK_LIBRARY_DIR", ODE_MT_STOCK_LIBRARY_DIR)},
              {"MALLOC_PERTURB_", "165"}});
    EXPECT_EQ(stock(), again);
}

TEST(EveryCall, serial) { compare("0", "auto"); }
TEST(EveryCall, twoThreads) { compare("2", "lcp"); }
TEST(EveryCall, clustered) { compare("2", "decluster"); }

}  // namespace
