#include "support/orphans.h"

#include <gtest/gtest.h>

#include <thread>

#include "support/child_run.h"

using namespace support;

namespace {

void passTime(std::chrono::milliseconds most) { std::this_thread::sleep_for(most); }

// In a process of its own, as it becomes the parent of all that others leave.
bool endsWhatIsLeftBy(const std::string &script, bool isThere) {
    return trueInChild([&] {
        adoptOrphans();
        waitFor(spawn({"/bin/sh", "-c", script}, {}, {}));
        const EndedOrphans ended = endOrphans(passTime);
        return ended.wereThere == isThere && !ended.areLeft;
    });
}

}  // namespace

TEST(Orphans, AreEndedAlsoInAProcessGroupOrSessionOfTheirOwn) {
    EXPECT_TRUE(endsWhatIsLeftBy("sleep 60 & setsid sleep 60 &", true));
    EXPECT_TRUE(endsWhatIsLeftBy("true", false));
}

TEST(Orphans, ThoseThatIgnoreSigtermAreKilled) {
    EXPECT_TRUE(endsWhatIsLeftBy("(trap '' TERM; while :; do sleep 1; done) & sleep 0.2", true));
}

TEST(Orphans, ThoseThatHaveEndedAreReaped) {
    EXPECT_TRUE(trueInChild([] {
        adoptOrphans();
        const pid_t child = spawn({"true"}, {}, {});
        passTime(std::chrono::milliseconds(200));
        reapOrphans();
        return waitFor(child) == 0 && !endOrphans(passTime).wereThere;
    }));
}
