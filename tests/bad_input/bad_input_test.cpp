// Bad arguments are answered as libode8 answers them, by number and text (with an assertion's file and line), in every
// function that its headers declare; and in ODE_MT's own functions as ode_MT.h says.
//
// Has found: dQuadTreeSpaceCreate did not end for a depth of two thousand million, where libode8
// crashes.
//
// Covers api/ode_MT.cpp, api/ode_MT_worlds.cpp.
#include "two_libraries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>

namespace {

using namespace exactness;

// A line is "function(arguments): what came of it".
std::string callOf(const std::string &line) { return line.substr(0, line.find("):") + 1); }
std::string answerOf(const std::string &line) { return line.substr(line.find("):") + 2); }

bool endsIn(const std::string &answer, const std::string &ending) {
    return answer.size() >= ending.size() &&
           answer.compare(answer.size() - ending.size(), ending.size(), ending) == 0;
}

// There is nothing to agree with.
bool isUndefined(const std::string &answer) {
    return answer.find(" signal ") != std::string::npos || endsIn(answer, " hangs") ||
           endsIn(answer, " throws");
}

bool isSettings(const std::string &call) { return call.rfind("dODE_MT_Set", 0) == 0; }

TEST(BadInput, UpstreamsFunctionsAnswerAsLibode8) {
    const Lines debian = linesOn(Library::Debian, {ODE_MT_BAD_INPUT_PROGRAM}, "0"),
                ours = linesOn(Library::Ours, {ODE_MT_BAD_INPUT_PROGRAM}, "0");
    ASSERT_EQ(debian.size(), ours.size());
    ASSERT_NE(debian[0], ours[0]) << "both ran on one library";
    int undefined = 0, answered = 0, different = 0;
    for (std::size_t i = 1; i < debian.size(); ++i) {
        ASSERT_EQ(callOf(debian[i]), callOf(ours[i]));
        const std::string expected = answerOf(debian[i]), actual = answerOf(ours[i]);
        if (isUndefined(expected)) {
            ++undefined;
            EXPECT_FALSE(endsIn(actual, " hangs") && !endsIn(expected, " hangs")) << debian[i] << "\n"
                                                                                  << ours[i];
            continue;
        }
        answered += expected != " returns";
        if (expected != actual && ++different <= 40)
            ADD_FAILURE() << "libode8: " << debian[i] << "\nODE_MT:  " << ours[i];
    }
    EXPECT_EQ(different, 0);
    EXPECT_GT(answered, 2000) << "upstream's assertions were not reached";
    RecordProperty("calls", static_cast<int>(debian.size() - 1));
    RecordProperty("answered", answered);
    RecordProperty("undefined", undefined);
}

// Where a NULL is allowed, or is answered by a message.
const std::map<std::string, std::string> kNullAnswers{
    {"dAreGeomsSame(NULL, geom0)", " returns"},
    {"dAreGeomsSame(geom0, NULL)", " returns"},
    {"dSpaceCollideAndWorldStep(space0, NULL, function, world0, 0.5, function)", " returns"},
    {"dWorldStepAndSpaceCollide(space0, NULL, function, world0, 0.5, function, function)", " returns"},
    {"dWorldStepAndSpaceCollide(space0, ones, function, world0, 0.5, function, NULL)", " returns"},
    {"dODE_MT_GetStatistics(NULL)",
     " message 0 \"ODE_MT: dODE_MT_GetStatistics was given no place for them (NULL)\" returns"},
    {"dODE_MT_StartTrace(NULL)", " message 0 \"ODE_MT: dODE_MT_StartTrace was given no file (NULL)\" returns"},
    {"dODE_MT_SetSolver(NULL, text)", " debug 2 \"bad world argument in dODE_MT_SetSolver()\""},
    {"dODE_MT_SetSolverTolerance(NULL, 0.5)", " debug 2 \"bad world argument in dODE_MT_SetSolverTolerance()\""},
    {"dODE_MT_SetWarmStart(NULL, 1)", " debug 2 \"bad world argument in dODE_MT_SetWarmStart()\""},
    {"dODE_MT_SetWorldThreads(NULL, 1)", " debug 2 \"bad world argument in dODE_MT_SetWorldThreads()\""},
    {"dODE_MT_SetSpaceThreads(NULL, 1)", " debug 2 \"bad space argument in dODE_MT_SetSpaceThreads()\""},
    {"dODE_MT_SetExecutor(NULL, ones)", " returns"},
    {"dODE_MT_SetExecutor(function, NULL)", " returns"},
    {"dODE_MT_SetThreadingImplementation(NULL, ones)",
     " message 0 \"ODE_MT: a threading implementation without functions (NULL)\" returns"},
    {"dODE_MT_SetThreadingImplementation(ones, NULL)",
     " message 0 \"ODE_MT: a threading implementation without implementation (NULL)\" returns"},
    {"dODE_MT_StepWorlds(worlds, 1, NULL, 0.5)", " message 0 \"ODE_MT: no stepper '(null)'; known: step, quick\" returns"},
    {"dODE_MT_SetWorkerName(NULL)", " returns"},
    {"dODE_MT_SetWorkerAffinity(NULL, 1)", " message 0 \"ODE_MT: no list of 1 processors (NULL); known: 0 to 1024\" returns"},
    {"dODE_MT_SetWorkerPriority(NULL, 1)", " returns"},
    {"dODE_MT_SetWorkerHooks(NULL, function, ones)", " returns"},
    {"dODE_MT_SetWorkerHooks(function, NULL, ones)", " returns"},
    {"dODE_MT_SetWorkerHooks(function, function, NULL)", " returns"},
};

void expectAnswerToNull(const std::string &call, const std::string &answer) {
    const std::string function = call.substr(0, call.find('('));
    const auto exception = kNullAnswers.find(call);
    if (exception != kNullAnswers.end())
        EXPECT_EQ(answer, exception->second) << call;
    else if (isSettings(call))
        EXPECT_NE(answer.find("'(null)'; known: "), std::string::npos) << call << answer;
    else
        EXPECT_TRUE(answer.rfind(" debug 2 \"bad ", 0) == 0 &&
                    endsIn(answer, " argument in " + function + "()\""))
            << call << answer;
}

TEST(BadInput, OwnFunctionsAnswerAsTheirHeaderSays) {
    const Lines lines = linesOn(Library::Ours, {ODE_MT_OWN_BAD_INPUT_PROGRAM}, "0");
    EXPECT_GT(lines.size(), 250u);
    int nulls = 0, messages = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::string call = callOf(lines[i]), answer = answerOf(lines[i]);
        EXPECT_FALSE(isUndefined(answer) || answer.find(" status ") != std::string::npos) << lines[i];
        messages += answer.rfind(" message 0 \"ODE_MT: ", 0) == 0;
        if (call.find("NULL") == std::string::npos) continue;
        ++nulls;
        expectAnswerToNull(call, answer);
    }
    EXPECT_GT(nulls, 25);
    EXPECT_GT(messages, 15);
}

// Any number says whether steps begin warm. Numbers of threads are brought into range, as those of dToggleODE_MT. The first processor is there.
constexpr const char *kGoodCalls[] = {"dODE_MT_SetGridCells(0)", "dODE_MT_SetGridCells(7)", "dODE_MT_SetSolverTolerance(world0, 0.5)",
                                      "dODE_MT_SetSolverTolerance(world0, 0)", "dODE_MT_SetSolverTolerance(world0, denormal)",
                                      "dODE_MT_SetWarmStart(", "dODE_MT_SetWorldThreads(", "dODE_MT_SetSpaceThreads(",
                                      "dODE_MT_SetExecutor(", "dODE_MT_SetThreadingImplementation(", "dODE_MT_SetWorkerName(NULL)",
                                      "dODE_MT_SetWorkerName(text)", "dODE_MT_SetWorkerName(format)", "dODE_MT_SetWorkerAffinity(ones, 1)",
                                      "dODE_MT_SetWorkerAffinity(ones, 0)", "dODE_MT_SetWorkerAffinity(zeros, 1)",
                                      "dODE_MT_SetWorkerAffinity(infs, 1)", "dODE_MT_SetWorkerAffinity(NaNs, 1)",
                                      "dODE_MT_SetWorkerStackSize(0)", "dODE_MT_SetWorkerStackSize(smallest)",
                                      "dODE_MT_SetWorkerHooks("};

// Numbers that are none, and names of nothing, are named, and the answer says what is known.
TEST(BadInput, OwnSettingsNameWhatTheyWereGiven) {
    const Lines lines = linesOn(Library::Ours, {ODE_MT_OWN_BAD_INPUT_PROGRAM, "dODE_MT_Set"}, "0");
    int refused = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (callOf(lines[i]).find("(NULL, ") != std::string::npos) continue;  // kNullAnswers
        const std::string call = callOf(lines[i]);
        const bool isGood = std::any_of(std::begin(kGoodCalls), std::end(kGoodCalls),
                                        [&call](const char *good) { return call.rfind(good, 0) == 0; });
        const std::string answer = answerOf(lines[i]);
        EXPECT_EQ(answer.find("; known: ") != std::string::npos, !isGood) << lines[i];
        refused += !isGood;
    }
    EXPECT_GT(refused, 20);
    for (const char *threads : {"dToggleODE_MT(-1)", "dToggleODE_MT(smallest)"}) {
        const Lines one = linesOn(Library::Ours, {ODE_MT_OWN_BAD_INPUT_PROGRAM, threads}, "0");
        ASSERT_EQ(one.size(), 2u);
        EXPECT_NE(one[1].find("the least is 0 (serial), which is taken\" returns"), std::string::npos)
            << one[1];
    }
}

}  // namespace
