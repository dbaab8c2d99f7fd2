#include "support/text.h"

#include <gtest/gtest.h>

using namespace support;
using Words = std::vector<std::string>;

TEST(Text, SplitKeepsEmptyPartsButForTheLast) {
    EXPECT_EQ(split("a,,b", ','), Words({"a", "", "b"}));
    EXPECT_EQ(split("a:b:", ':'), Words({"a", "b"}));
    EXPECT_EQ(split("", ','), Words());
}

TEST(Text, WordsAreBetweenBlanks) {
    EXPECT_EQ(splitAtBlanks("  1 2\t3\n"), Words({"1", "2", "3"}));
    EXPECT_EQ(splitAtBlanks(" "), Words());
}

TEST(Text, AnEscapedCommaIsPartOfAWord) {
    EXPECT_EQ(splitAtCommas("a\\,b.sdf,c"), Words({"a\\,b.sdf", "c"}));
    EXPECT_EQ(splitAtCommas("a,,b,"), Words({"a", "", "b"}));
    EXPECT_EQ(withoutEscapes("a\\,b.sdf"), "a,b.sdf");
    EXPECT_EQ(withoutEscapes("a\\b"), "a\\b");
}

TEST(Text, JoinPutsTheSeparatorBetween) {
    EXPECT_EQ(join({"a", "b", "c"}), "a, b, c");
    EXPECT_EQ(join({"a", "b"}, " or "), "a or b");
    EXPECT_EQ(join({}), "");
}

TEST(Text, QuotesAreDoubledWithinQuotes) { EXPECT_EQ(doubleQuoted("a\"b"), "\"a\"\"b\""); }

TEST(CsvField, OrdinaryTextStaysAsItIs) { EXPECT_EQ(csvField("ours:2/lcp"), "ours:2/lcp"); }

TEST(CsvField, CommasQuotesAndLineBreaksAreQuoted) {
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("a\"b"), "\"a\"\"b\"");
    EXPECT_EQ(csvField("a\nb"), "\"a\nb\"");
}

TEST(Text, WhatCannotBeShownIsWrittenAsBytes) {
    EXPECT_EQ(printable("a\x1b[31mb\n"), "a\\x1b[31mb\\x0a");
    EXPECT_EQ(printable("\xc3\xa4\xe2\x82\xac"), "\xc3\xa4\xe2\x82\xac");
    EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
    EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae") << "turns the direction of what follows";
}

TEST(Text, LongTextIsCutInTheMiddleBetweenCharacters) {
    EXPECT_EQ(quote("short"), "'short'");
    const std::string text = "x" + std::string(150, 'a') + std::string(150, 'b');
    EXPECT_EQ(shortened(text), "x" + std::string(99, 'a') + "..." + std::string(100, 'b'));
    std::string umlauts;
    for (int i = 0; i < 151; ++i) umlauts += "\xc3\xa4";
    EXPECT_EQ(printable(shortened("x" + umlauts)), shortened("x" + umlauts));
}
