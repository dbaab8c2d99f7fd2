// The log: which levels are shown, long lines, control characters, the variable ODE_MT_LOG.
//
// Covers dxEnvironment.cpp.
#include "core/dxLog.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

std::string said(dxLogLevel shown, dxLogLevel level) {
    const dxLogLevel before = dxGetLogLevel();
    dxSetLogLevel(shown);
    testing::internal::CaptureStderr();
    dxLog(level, "%d boxes", 3);
    dxSetLogLevel(before);
    return testing::internal::GetCapturedStderr();
}

TEST(Log, ShowsTheLevelAndMoreUrgentOnes) {
    EXPECT_EQ(said(dxLogLevel::Warning, dxLogLevel::Warning), "ODE_MT warning: 3 boxes\n");
    EXPECT_EQ(said(dxLogLevel::Warning, dxLogLevel::Error), "ODE_MT error: 3 boxes\n");
    EXPECT_EQ(said(dxLogLevel::Warning, dxLogLevel::Info), "");
    EXPECT_EQ(said(dxLogLevel::Debug, dxLogLevel::Info), "ODE_MT info: 3 boxes\n");
}

TEST(Log, CutsLongLines) {
    testing::internal::CaptureStderr();
    dxLog(dxLogLevel::Error, "%s", std::string(5000, 'x').c_str());
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "ODE_MT error: " + std::string(1000, 'x') + "\n");
}

TEST(Log, HidesControlCharacters) {
    testing::internal::CaptureStderr();
    dxLog(dxLogLevel::Error, "%s", "\x1b[31m a\nb\x7f \xc2\x9b \xc2\xa0\xc3\xa9");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "ODE_MT error: ?[31m a?b? ?? \xc2\xa0\xc3\xa9\n");
}

TEST(Log, KnowsItsLevels) {
    dxLogLevel level = dxLogLevel::Error;
    EXPECT_TRUE(dxLogLevelFromName("debug", level));
    EXPECT_EQ(level, dxLogLevel::Debug);
    EXPECT_FALSE(dxLogLevelFromName("loud", level));
}

// The environment is read once in a process, so this needs one of its own.
TEST(LogDeathTest, ReadsTheEnvironment) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto speak = [](const char *level) {
        setenv("ODE_MT_LOG", level, 1);
        dxLog(dxLogLevel::Info, "spoken");
        std::exit(dxGetLogLevel() == dxLogLevel::Info ? 0 : 1);
    };
    EXPECT_EXIT(speak("info"), testing::ExitedWithCode(0), "ODE_MT info: spoken");
    EXPECT_EXIT(speak("loud"), testing::ExitedWithCode(1),
                "ODE_MT warning: ODE_MT_LOG is 'loud'; known: error, warning, info, debug");
}

}  // namespace
