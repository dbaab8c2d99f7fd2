// worlds/elements.md says what the table of elements says.
#include "loader/read/element_rules.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

TEST(ElementDocs, AreWhatTheTableSays) {
    std::ostringstream text;
    text << std::ifstream(ELEMENTS_FILE).rdbuf();
    if (text.str() == worlds::elementDocs()) return;
    const std::string made = testing::TempDir() + "/elements.md";
    std::ofstream(made) << worlds::elementDocs();
    ADD_FAILURE() << ELEMENTS_FILE << " is not what the table says, which is now in " << made;
}

}  // namespace
