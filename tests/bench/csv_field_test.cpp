#include "csv_field.h"

#include <gtest/gtest.h>

using bench::csvField;

TEST(CsvField, OrdinaryTextStaysAsItIs) { EXPECT_EQ(csvField("ours:2/lcp"), "ours:2/lcp"); }

TEST(CsvField, CommasQuotesAndLineBreaksAreQuoted) {
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("a\"b"), "\"a\"\"b\"");
    EXPECT_EQ(csvField("a\nb"), "\"a\nb\"");
}
