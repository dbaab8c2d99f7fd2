#include "machine.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace bench;

namespace {

std::string processorIn(const std::string &text) {
    std::istringstream stream(text);
    return readProcessor(stream);
}

}  // namespace

TEST(Machine, TheFirstProcessorIsNamed) {
    EXPECT_EQ(processorIn("processor\t: 0\nmodel name\t: Core i5: fast\nmodel name\t: other\n"),
              "Core i5: fast");
}

TEST(Machine, NoNameIsNoError) {
    EXPECT_EQ(processorIn("processor : 0\n"), "");
    EXPECT_EQ(processorIn("model name\t:\n"), "");
    EXPECT_EQ(processorIn(""), "");
}

TEST(Machine, ThisOneHasACore) { EXPECT_GE(thisMachine().cores, 1u); }
