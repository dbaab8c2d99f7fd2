// The thread managers that every test of the contract runs on, and what the contract leaves to each.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "threading/dxThreadManager.h"

struct ManagerKind {
    std::string name;
    // A manager with that many workers; keeps whatever it needs (a pool of ODE's) alive.
    std::shared_ptr<dxThreadManager> (*make)(unsigned workers);
    unsigned maxWorkers;       // tests with more are skipped: too slow to be useful
    bool ownThreads;            // starts its threads itself
    bool endsThreads;           // and ends them all
    bool waitsForIdleWorkers;   // a run ends only when all its threads have come
    bool sharesConcurrentRuns;  // runs at one time, and nested ones, all get workers
    bool workersInForkedChild;
};

void PrintTo(const ManagerKind &kind, std::ostream *out);

// ManagerKinds.cpp instantiates the tests of all files.
class ThreadManagerTest : public testing::TestWithParam<ManagerKind> {};
