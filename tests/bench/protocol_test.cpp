#include "protocol.h"

#include <gtest/gtest.h>

#include "complaint.h"

using namespace bench;

TEST(Protocol, ABatchArrivesAsItWasSent) {
    Batch sent;
    sent.frames = 7;
    sent.seconds = {0.1, 1.0 / 3, 3e-9, 2, 0.25};
    sent.frameTimes.add(0.25);
    sent.frameTimes.add(0.5);
    sent.hash = 0xfedcba9876543210;
    sent.contacts = 12;
    sent.messages = 3;
    sent.sharedSteps = 5;
    sent.work = {0.25, 0.75};
    const Batch got = readBatch(writeBatch(sent));
    EXPECT_EQ(got.frames, 7);
    EXPECT_EQ(got.seconds.control, sent.seconds.control);
    EXPECT_EQ(got.seconds.collide, sent.seconds.collide);
    EXPECT_EQ(got.seconds.step, sent.seconds.step);
    EXPECT_EQ(got.seconds.finish, sent.seconds.finish);
    EXPECT_EQ(got.seconds.callbacks, sent.seconds.callbacks);
    EXPECT_EQ(got.frameTimes.counts(), sent.frameTimes.counts());
    EXPECT_EQ(got.hash, sent.hash);
    EXPECT_EQ(got.contacts, 12u);
    EXPECT_EQ(got.messages, 3u);
    EXPECT_EQ(got.sharedSteps, 5u);
    EXPECT_EQ(got.work.alone, 0.25);
    EXPECT_EQ(got.work.shared, 0.75);
}

TEST(Protocol, AReadyArrivesAsItWasSent) {
    Ready sent;
    sent.library = "/a folder/libode.so.8";
    sent.isOurs = true;
    sent.release = "0.16.6";
    sent.threads = 3;
    sent.manager = "pthread";
    sent.algorithm = "auto";
    sent.callbacks = "concurrent";
    sent.gridCells = 9;
    sent.bodies = 1;
    sent.joints = 2;
    sent.geoms = 3;
    sent.stepSize = 0.008;
    sent.warnings = {"\"odd\"\nelement"};
    const Ready got = readReady(writeReady(sent));
    EXPECT_EQ(got.library, sent.library);
    EXPECT_TRUE(got.isOurs);
    EXPECT_EQ(got.release, "0.16.6");
    EXPECT_EQ(got.threads, 3);
    EXPECT_EQ(got.manager, "pthread");
    EXPECT_EQ(got.algorithm, "auto");
    EXPECT_EQ(got.callbacks, "concurrent");
    EXPECT_EQ(got.gridCells, 9);
    EXPECT_EQ(got.bodies, 1u);
    EXPECT_EQ(got.joints, 2u);
    EXPECT_EQ(got.geoms, 3u);
    EXPECT_EQ(got.stepSize, 0.008);
    EXPECT_EQ(got.warnings, sent.warnings);
}

TEST(Protocol, MessagesAreOneLine) { EXPECT_EQ(writeError("two\nlines").find('\n'), std::string::npos); }

TEST(Protocol, ControlCharactersOfAnErrorAreShown) {
    EXPECT_EQ(complaint([] { readBatch(writeError("no world '\x1b[31m'")); }), "no world '\\x1b[31m'");
}

TEST(Protocol, ARequestArrivesAsItWasSent) { EXPECT_EQ(readRequest(writeRequest(1000)), 1000); }

TEST(Protocol, AnErrorIsThrownInTheChildsOwnWords) {
    EXPECT_EQ(complaint([] { readBatch(writeError("no such world")); }), "no such world");
    EXPECT_EQ(complaint([] { readReady(writeError("no such world")); }), "no such world");
}

TEST(Protocol, ALineThatIsNotUnderstoodIsQuoted) {
    for (const char *line : {"Segmentation fault", "{}", "{\"batch\":{\"frames\":1}}", ""})
        EXPECT_NE(complaint([&] { readBatch(line); }).find("'" + std::string(line) + "'"), std::string::npos);
}

TEST(Protocol, HashesHaveSixteenDigits) { EXPECT_EQ(hashText(0xab), "00000000000000ab"); }
