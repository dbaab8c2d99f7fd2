#include "size_range.h"

#include <gtest/gtest.h>

using bench::expandSizes;
using Worlds = std::vector<std::string>;

TEST(SizeRange, SizesDouble) {
    EXPECT_EQ(expandSizes("pile:1000..4000"), (Worlds{"pile:1000", "pile:2000", "pile:4000"}));
    EXPECT_EQ(expandSizes("pile:3..23,sap,quick"),
              (Worlds{"pile:3,sap,quick", "pile:6,sap,quick", "pile:12,sap,quick"}));
    EXPECT_EQ(expandSizes("pile:5..5"), (Worlds{"pile:5"}));
    EXPECT_EQ(expandSizes("a:b/world.sdf:7..14"), (Worlds{"a:b/world.sdf:7", "a:b/world.sdf:14"}));
}

TEST(SizeRange, AWorldWithoutARangeIsItself) {
    for (const char *world : {"rover", "pile:4000", "pile:4000,sap", "../a/b.sdf", "../a/b.sdf:40", ""})
        EXPECT_EQ(expandSizes(world), Worlds{world});
}

TEST(SizeRange, ARangeThatMakesNoSenseIsLeftToBeComplainedOf) {
    for (const char *world : {"pile:4..2", "pile:0..2", "pile:..2", "pile:2..", "pile:2..x", "pile:-1..2",
                              "pile:1...4", "pile:1..99999999999"})
        EXPECT_EQ(expandSizes(world), Worlds{world});
}
