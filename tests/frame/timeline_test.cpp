// The timeline (docs/tools.md): what is recorded, that events nest, what a full ring tells, when the file is written, who writes it.
//
// Covers api/ode_MT.cpp, dxStepTimeline.cpp, dxTimelineClock.cpp, dxTimelineFile.cpp, dxTimelineRing.cpp, dxWorkersRunner.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "last_message.h"
#include "threading/timeline/dxTimelineRing.h"

namespace {

using nlohmann::json;

std::string pathOf(const char *name) { return testing::TempDir() + "timeline-" + std::to_string(getpid()) + "-" + name + ".json"; }

json read(const std::string &path) {
    std::ifstream file(path);
    return json::parse(file);
}

std::vector<json> eventsOf(const json &trace, const std::string &phase) {
    std::vector<json> events;
    for (const json &event : trace.at("traceEvents"))
        if (event.at("ph") == phase) events.push_back(event);
    return events;
}

// us, added up as viewers do: that events nest needs sums that are exact.
double beginOf(const json &event) { return event.at("ts"); }
double endOf(const json &event) { return beginOf(event) + event.at("dur").get<double>(); }

std::map<long, std::vector<json>> byThread(const json &trace) {
    std::map<long, std::vector<json>> threads;
    for (const json &event : eventsOf(trace, "X")) threads[event.at("tid")].push_back(event);
    return threads;
}

// Each event has a duration, and of two of a thread one lies within the other or they do not meet.
void expectNested(const json &trace) {
    for (auto &[thread, events] : byThread(trace)) {
        std::stable_sort(events.begin(), events.end(), [](const json &a, const json &b) {
            return beginOf(a) != beginOf(b) ? beginOf(a) < beginOf(b) : endOf(a) > endOf(b);
        });
        std::vector<const json *> around;
        for (const json &event : events) {
            ASSERT_GE(endOf(event), beginOf(event));
            while (!around.empty() && endOf(*around.back()) <= beginOf(event)) around.pop_back();
            if (!around.empty()) {
                ASSERT_LE(endOf(event), endOf(*around.back())) << event << " reaches out of " << *around.back();
            }
            around.push_back(&event);
        }
    }
}

std::set<std::string> namesOf(const json &trace) {
    std::set<std::string> names;
    for (const json &event : trace.at("traceEvents")) names.insert(event.at("name"));
    return names;
}

double timeOf(const json &trace, const std::set<std::string> &names) {
    double time = 0;
    for (const json &event : eventsOf(trace, "X"))
        if (names.count(event.at("name")) != 0) time += event.at("dur").get<double>();
    return time;
}

void play(HeapWorld &heap, int frames) {
    for (int i = 0; i < frames; ++i) {
        heap.collide();
        heap.step();
    }
}

class Timeline : public testing::Test {
protected:
    Timeline() : path(pathOf(testing::UnitTest::GetInstance()->current_test_info()->name())) { unsetenv("ODE_MT_TRACE"); }
    ~Timeline() override {
        dODE_MT_StopTrace();
        dSetMessageHandler(nullptr);
        std::remove(path.c_str());
    }

    const OdeSession session{2, "lcp"};
    const std::string path;
};

TEST_F(Timeline, HasTheStagesThatRan) {
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    {
        HeapWorld heap(dHashSpaceCreate(nullptr));
        play(heap, 20);
        ChainWorld(64, 16).step(3);
    }
    ASSERT_EQ(dODE_MT_StopTrace(), 1);
    const json trace = read(path);
    expectNested(trace);
    const std::set<std::string> names = namesOf(trace);
    for (const char *name : {"collide", "broad phase", "near-callbacks", "narrow-phase prefetch", "boxes", "step", "island search", "islands",
                             "island preparation", "island survey", "commit", "island", "solver", "pairs", "contacts", "rows", "threads"})
        EXPECT_EQ(names.count(name), 1u) << name;
    std::set<int> frames;
    for (const json &event : eventsOf(trace, "X"))
        if (event.at("name") == "step") frames.insert(event.at("args").at("frame").get<int>());
    EXPECT_EQ(frames.size(), 23u);
    EXPECT_EQ(*frames.rbegin() - *frames.begin(), 22);
    EXPECT_EQ(trace.at("otherData").at("eventsDropped"), 0);
}

TEST_F(Timeline, TopLevelStagesCoverStepAndCollision) {
    OdeSession::use(1, "serial");
    HeapWorld heap(dHashSpaceCreate(nullptr));
    play(heap, 2);
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    play(heap, 10);
    ASSERT_EQ(dODE_MT_FlushTrace(), 1);
    const json trace = read(path);
    EXPECT_GT(timeOf(trace, {"island search", "islands in order"}), 0.9 * timeOf(trace, {"step"}));
    EXPECT_GT(timeOf(trace, {"broad phase", "near-callbacks"}), 0.9 * timeOf(trace, {"collide"}));
}

TEST_F(Timeline, CountsWhatAStepHas) {
    OdeSession::use(1, "serial");
    dWorldID world = dWorldCreate();
    const dJointGroupID contacts = dJointGroupCreate(0);
    for (int i = 0; i < 3; ++i) {
        const dBodyID body = dBodyCreate(world);
        dContact contact{};
        contact.geom.normal[2] = 1;
        contact.geom.depth = dReal(0.01);
        dJointAttach(dJointCreateContact(world, contacts, &contact), body, nullptr);
    }
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    dWorldStep(world, dReal(0.01));
    dWorldQuickStep(world, dReal(0.01));
    dODE_MT_SetSolver(world, "fast");
    dWorldQuickStep(world, dReal(0.01));
    ASSERT_EQ(dODE_MT_StopTrace(), 1);
    dJointGroupDestroy(contacts);
    dWorldDestroy(world);
    std::map<std::string, std::vector<int>> counters;
    for (const json &event : eventsOf(read(path), "C")) counters[event.at("name")].push_back(event.at("args").begin()->get<int>());
    EXPECT_EQ(counters["islands"], (std::vector<int>{3, 3, 1}));  // fast: small ones are joined
    EXPECT_EQ(counters["contacts"], (std::vector<int>{3, 3, 3}));
    EXPECT_EQ(counters["rows"], (std::vector<int>{3, 3, 3}));  // one a contact: they have no friction
    EXPECT_EQ(counters["threads"], (std::vector<int>{1, 1, 1}));
}

TEST_F(Timeline, ChangesNoBit) {
    const auto positions = [this](bool isRecorded) {
        dRandSetSeed(7);
        HeapWorld heap(dHashSpaceCreate(nullptr));
        if (isRecorded) dODE_MT_StartTrace(path.c_str());
        play(heap, 20);
        return heap.positions();
    };
    EXPECT_EQ(positions(true), positions(false));
}

TEST_F(Timeline, AFullRingTellsWhatItHasDropped) {
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    const auto ring = std::make_unique<dxTimelineRing>();
    ring->own(1);
    constexpr dxTimelineEvent kEvent{"event", "test", {"number"}};
    for (std::uint64_t i = 0; i < dxTimelineRing::kCapacity + 10; ++i) ring->add(kEvent, i, i, {i});
    std::vector<dxTimelineRecord> records;
    EXPECT_EQ(ring->read(records), 11u);  // the place of one more may be being written
    ASSERT_EQ(records.size(), dxTimelineRing::kCapacity - 1);
    for (std::uint64_t i = 0; i < records.size(); ++i) ASSERT_EQ(records[i].arguments[0], i + 11);

    ChainWorld chain(1, 2);
    chain.step(dxTimelineRing::kCapacity / 2);
    ASSERT_EQ(dODE_MT_FlushTrace(), 1);
    const json trace = read(path);
    expectNested(trace);
    const long long dropped = trace.at("otherData").at("eventsDropped").get<long long>();
    EXPECT_GT(dropped, 0);
    ASSERT_EQ(eventsOf(trace, "i").size(), 1u);
    EXPECT_EQ(eventsOf(trace, "i")[0].at("args").at("dropped"), dropped);
    EXPECT_LE(eventsOf(trace, "X").size(), dxTimelineRing::kCapacity);
}

TEST_F(Timeline, ASignalAsksForTheFile) {
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    ChainWorld chains(2, 3);
    chains.step();
    signal(SIGUSR1, [](int) { dODE_MT_RequestTraceFlush(); });
    raise(SIGUSR1);
    signal(SIGUSR1, SIG_DFL);
    EXPECT_TRUE(eventsOf(read(path), "X").empty());
    chains.step();
    const std::size_t written = eventsOf(read(path), "X").size();
    EXPECT_GT(written, 0u);
    chains.step();
    EXPECT_EQ(eventsOf(read(path), "X").size(), written) << "once for a request";
}

TEST_F(Timeline, TwoWorldsOnTwoThreads) {
    constexpr unsigned kSteps = 40;
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    const auto run = [] {
        dAllocateODEDataForThread(dAllocateMaskAll);
        ChainWorld chains(20, 4);
        for (unsigned i = 0; i < kSteps; ++i) {
            chains.step();
            if (i % 16 == 0) {
                EXPECT_EQ(dODE_MT_FlushTrace(), 1);
            }
        }
    };
    std::thread other(run);
    run();
    other.join();
    ASSERT_EQ(dODE_MT_FlushTrace(), 1);
    const json trace = read(path);
    expectNested(trace);
    std::map<long, std::set<unsigned>> frames;  // by caller
    for (const auto &[thread, events] : byThread(trace)) {
        for (const json &event : events) {
            if (event.at("cat") == "idle") continue;
            const long caller = event.at("args").at("caller");
            if (event.at("name") == "step") {
                EXPECT_EQ(caller, thread);
                frames[caller].insert(event.at("args").at("frame").get<unsigned>());
            }
        }
    }
    ASSERT_EQ(frames.size(), 2u);
    for (const auto &[caller, ofCaller] : frames) EXPECT_EQ(ofCaller.size(), kSteps);
}

TEST_F(Timeline, AForkedChildLeavesTheFileOfItsParentAlone) {
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    ChainWorld chains(20, 4);
    chains.step(2);
    ASSERT_EQ(dODE_MT_FlushTrace(), 1);
    const json before = read(path);
    const std::string own = path + ".child";
    EXPECT_TRUE(support::trueInChild([&] {
        chains.step(2);
        dODE_MT_RequestTraceFlush();
        chains.step(2);
        if (dODE_MT_FlushTrace() != 0) return false;
        if (dODE_MT_StartTrace(own.c_str()) != 1) return false;
        chains.step(3);
        return dODE_MT_StopTrace() == 1;
    }));
    EXPECT_EQ(read(path), before);
    std::size_t steps = 0;
    for (const json &event : eventsOf(read(own), "X")) steps += event.at("name") == "step";
    EXPECT_EQ(steps, 3u);
    std::remove(own.c_str());
    chains.step(2);
    EXPECT_EQ(dODE_MT_FlushTrace(), 1);
    EXPECT_GT(read(path).at("traceEvents").size(), before.at("traceEvents").size());
}

TEST_F(Timeline, AFileThatCannotBeWrittenIsReported) {
    dSetMessageHandler(keepLastMessage);
    ChainWorld chains(2, 3);
    EXPECT_EQ(dODE_MT_StartTrace("/nonexistent/trace.json"), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: the trace '/nonexistent/trace.json' cannot be written: No such file or directory");
    EXPECT_EQ(dODE_MT_StartTrace("/dev/full"), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: the trace '/dev/full' cannot be written: No space left on device");
    EXPECT_EQ(dODE_MT_StartTrace(nullptr), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: dODE_MT_StartTrace was given no file (NULL)");
    EXPECT_EQ(dODE_MT_StartTrace(""), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: dODE_MT_StartTrace was given no file (an empty name)");
    lastMessage.clear();
    chains.step();
    EXPECT_EQ(dODE_MT_FlushTrace(), 0);
    EXPECT_EQ(dODE_MT_StopTrace(), 0);
    EXPECT_EQ(lastMessage, "");

    // A file that has grown as large as the process's files may be.
    const rlimit small{10000, RLIM_INFINITY}, none{RLIM_INFINITY, RLIM_INFINITY};
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    for (int frame = 0; frame < 30; ++frame) chains.step();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_EQ(dODE_MT_StopTrace(), 0);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: the trace '" + path + "' cannot be written: File too large");

    const std::string folder = path + ".folder";
    std::string command = "mkdir '" + folder + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    ASSERT_EQ(dODE_MT_StartTrace((folder + "/trace").c_str()), 1);
    command = "rm -r '" + folder + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    chains.step();
    EXPECT_EQ(dODE_MT_FlushTrace(), 0);
    EXPECT_EQ(lastMessage, "ODE_MT: the trace '" + folder + "/trace' cannot be written: No such file or directory");
}

TEST_F(Timeline, EventsOfAThreadThatHasEndedAreKept) {
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    for (int i = 0; i < 3; ++i) {
        std::thread([] {
            pthread_setname_np(pthread_self(), "a \"short\" one");
            dAllocateODEDataForThread(dAllocateMaskAll);
            ChainWorld(1, 2).step();
        }).join();
    }
    ASSERT_EQ(dODE_MT_FlushTrace(), 1);
    std::size_t named = 0;
    for (const json &event : eventsOf(read(path), "M")) named += event.at("args").at("name") == "a \"short\" one";
    EXPECT_EQ(named, 3u);
}

TEST_F(Timeline, ANewTraceForgetsTheOldOne) {
    const std::string other = path + ".other";
    ChainWorld chains(1, 2);
    ASSERT_EQ(dODE_MT_StartTrace(path.c_str()), 1);
    chains.step(5);
    ASSERT_EQ(dODE_MT_StartTrace(other.c_str()), 1);
    chains.step(2);
    ASSERT_EQ(dODE_MT_StopTrace(), 1);
    chains.step(4);
    const auto steps = [](const json &trace) {
        std::size_t count = 0;
        for (const json &event : eventsOf(trace, "X")) count += event.at("name") == "step";
        return count;
    };
    EXPECT_EQ(steps(read(path)), 5u);
    EXPECT_EQ(steps(read(other)), 2u);
    std::remove(other.c_str());
}

using TimelineDeathTest = Timeline;

TEST_F(TimelineDeathTest, TheEnvironmentStartsIt) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [](const std::string &file) {
        setenv("ODE_MT_TRACE", file.c_str(), 1);
        dInitODE2(0);
        {
            ChainWorld chains(20, 4);
            chains.step(2);
        }
        std::exit(0);  // without dCloseODE
    };
    EXPECT_EXIT(run("/nonexistent/trace.json"), testing::ExitedWithCode(0),
                "ODE_MT warning: the trace '/nonexistent/trace.json' cannot be written: No such file or directory");
    EXPECT_EXIT(run(""), testing::ExitedWithCode(0), "^$");
    const std::string folder = testing::TempDir() + "timeline-of-environment";  // of both processes
    const std::string make = "mkdir -p '" + folder + "'", list = "ls '" + folder + "' | grep -Ec '^trace-[0-9]+.json$'";
    ASSERT_EQ(std::system(make.c_str()), 0);
    EXPECT_EXIT(run(folder + "/trace-%p.json"), testing::ExitedWithCode(0), "^$");
    EXPECT_EQ(std::system((list + " > /dev/null").c_str()), 0);
    EXPECT_EQ(std::system(("rm -r '" + folder + "'").c_str()), 0);
}

}  // namespace
