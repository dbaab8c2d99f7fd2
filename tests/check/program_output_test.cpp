// What programs print: kept, and compared.
#include "check/program_output.h"

#include <gtest/gtest.h>

namespace check {

namespace {

TEST(ProgramOutput, TheFirstLineThatDiffersIsFound) {
    EXPECT_FALSE(firstDifferentLine("", ""));
    EXPECT_FALSE(firstDifferentLine("a\nb\n", "a\nb\n"));
    const auto difference = firstDifferentLine("a\nb\nc\n", "a\nx\nc\n");
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->line, 2u);
    EXPECT_EQ(difference->left, "b");
    EXPECT_EQ(difference->right, "x");
    EXPECT_EQ(firstDifferentLine("a\n", "a\nb\n")->left, "nothing");
    EXPECT_EQ(firstDifferentLine("a\nb\n", "a\n")->right, "nothing");
}

TEST(ProgramOutput, LinesOfOdeMtsLogDoNotCount) {
    EXPECT_FALSE(firstDifferentLine("a\nb\n", "ODE_MT info: 2 threads\na\nb\nODE_MT warning: x\n"));
    EXPECT_EQ(firstDifferentLine("a\nb\n", "ODE_MT info: 2 threads\na\nc\n")->line, 2u);
}

TEST(ProgramOutput, MessagesOfOdeHaveNoPlacesInItsSource) {
    const std::string errors =
        "something\n\nODE Message 2: mass must be > 0 in dMassAdjust() [mass.cpp:123]\nelse\nODE Error 1: x\n";
    EXPECT_EQ(odeMessages(errors), "ODE Message 2: mass must be > 0 in dMassAdjust() [file:line]\nODE Error 1: x\n");
}

TEST(ProgramOutput, TheLastLinesAreFound) {
    ProgramOutput output;
    EXPECT_EQ(output.lastLines(2), "");
    for (const std::string text : {"one\n", "two\nthree", "\n\n"}) output.append(text.data(), text.size());
    EXPECT_EQ(output.lastLines(1), "three");
    EXPECT_EQ(output.lastLines(2), "two\nthree");
    EXPECT_EQ(output.lastLines(9), "one\ntwo\nthree");
}

TEST(ProgramOutput, NoMoreIsKeptThanThereIsRoomFor) {
    ProgramOutput output;
    const std::string bytes(ProgramOutput::kMaxKept - 1, 'x');
    output.append(bytes.data(), bytes.size());
    EXPECT_FALSE(output.isCut());
    output.append("abc", 3);
    EXPECT_TRUE(output.isCut());
    EXPECT_EQ(output.text().size(), ProgramOutput::kMaxKept);
    output.append("abc", 3);
    EXPECT_EQ(output.text().size(), ProgramOutput::kMaxKept);
}

}  // namespace

}  // namespace check
