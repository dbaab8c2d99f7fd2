// Every exported function of upstream's, called on live objects in every context, and three frames after it,
// on Debian's libode8 and on ODE_MT: nothing that the library keeps from call to call may have missed the
// call.
//
// Covers api/collision.cpp, api/collision_trimesh.cpp, api/objects.cpp.
#include "support/child_run.h"
#include "thorough.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <future>
#include <map>
#include <sstream>
#include <string>

namespace {

using Variables = std::map<std::string, std::string>;

struct Statistics {
    unsigned maxWorkers = 0, contactsAhead = 0, parallelSteps = 0;
};

struct Outcomes {
    std::map<std::string, std::string> byCase;  // hash or ending
    Statistics statistics;                      // of all processes together
};

std::string fromEnvironment(const char *variable, const char *otherwise) {
    const char *value = std::getenv(variable);
    return value == nullptr ? otherwise : value;
}

void add(Statistics &sum, const std::string &line) {
    std::istringstream text(line);
    Statistics process;
    text >> process.maxWorkers >> process.contactsAhead >> process.parallelSteps;
    EXPECT_FALSE(text.fail()) << line;
    sum.maxWorkers = std::max(sum.maxWorkers, process.maxWorkers);
    sum.contactsAhead += process.contactsAhead;
    sum.parallelSteps += process.parallelSteps;
}

// Lines are "function/context/space/place/turn hash", and "statistics/function numbers" at the end of each
// process; one that crashed leaves "... ended by ...".
Outcomes play(Variables variables) {
    const support::TemporaryFolder folder;
    const std::string path = folder.file("outcomes");
    const support::Ending child =
        support::runProgram({ODE_MT_EVERY_CALL_PROGRAM, "--run", path}, variables);
    EXPECT_TRUE(child.exitedWith(0)) << child.text();
    Outcomes outcomes;
    std::ifstream lines(path);
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find(' ')), rest = line.substr(line.find(' ') + 1);
        if (name.rfind("statistics/", 0) == 0)
            add(outcomes.statistics, rest);
        else
            outcomes.byCase[name] = rest;
    }
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
    const auto &expected = stock().byCase;
    EXPECT_GT(expected.size(), 5000u);
    EXPECT_EQ(actual.byCase.size(), expected.size()) << "a process has crashed, or ended early";
    int different = 0;
    for (const auto &[name, outcome] : expected) {
        const auto found = actual.byCase.find(name);
        const std::string other = found == actual.byCase.end() ? "nothing" : found->second;
        if (other != outcome && ++different <= 60) {
            ADD_FAILURE() << name << " differs: every_call --show " << name
                          << " on both libraries shows where (" << outcome << ", " << other << ")";
        }
    }
    EXPECT_EQ(different, 0) << "cases differ";
}

Statistics compare(const char *threads, const char *algorithm) {
    const Outcomes actual = play({{"LD_LIBRARY_PATH", fromEnvironment("ODE_MT_LIBRARY_DIR", ODE_MT_LIBRARY_DIR)},
                                  {"ODE_MT_THREADS", threads},
                                  {"ODE_MT_ALGORITHM", algorithm}});
    compare(actual);
    return actual.statistics;
}

// Both runs at the same time; the second with a pattern in fresh memory. What does not repeat fails the other tests too: this one tells
// that the library is not to blame.
TEST(EveryCall, isRepeatable) {
    if (!exactness::isThorough()) GTEST_SKIP() << "only with ODE_MT_EXACTNESS=thorough";
    Variables patterned = stockLibrary();
    patterned["MALLOC_PERTURB_"] = "165";
    auto again = std::async(std::launch::async, play, patterned);
    stock();
    compare(again.get());
}

TEST(EveryCall, serial) { EXPECT_EQ(compare("0", "auto").maxWorkers, 0u); }

TEST(EveryCall, twoThreads) {
    const Statistics statistics = compare("2", "lcp");
    EXPECT_GE(statistics.maxWorkers, 2u);
    EXPECT_GT(statistics.contactsAhead, 0u);
    EXPECT_GT(statistics.parallelSteps, 0u);
}

TEST(EveryCall, clustered) {
    const Statistics statistics = compare("2", "decluster");
    EXPECT_GE(statistics.maxWorkers, 2u);
    EXPECT_GT(statistics.parallelSteps, 0u);
}

}  // namespace
