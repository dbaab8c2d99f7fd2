#include "table.h"

#include <gtest/gtest.h>

#include <limits>

using namespace bench;

TEST(NumberText, HasThreeDigitsButNoMoreThanFourBehindThePoint) {
    EXPECT_EQ(numberText(1234.5), "1234");
    EXPECT_EQ(numberText(12.345), "12.3");
    EXPECT_EQ(numberText(1.2345), "1.23");
    EXPECT_EQ(numberText(0.12345), "0.123");
    EXPECT_EQ(numberText(0.0000123), "0.0000");
    EXPECT_EQ(millisecondsText(0.0123), "12.3");
}

TEST(NumberText, WhatIsNotKnownIsADash) {
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "-");
    EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "-");
}

TEST(Table, ColumnsAreAsWideAsTheirWidestCell) {
    Table table({{"engine", Table::Align::Left}, {"ms"}});
    table.addRow({"stock", "1.5"});
    table.addRow({"stock-pool:2", "100"});
    EXPECT_EQ(table.text(),
              "engine         ms\n"
              "------------  ---\n"
              "stock         1.5\n"
              "stock-pool:2  100\n");
}

TEST(Table, LettersOfSeveralBytesCountOnce) {
    Table table({{"mean"}, {"x", Table::Align::Left}});
    table.addRow({"1 ± 2", "a"});
    EXPECT_EQ(table.text(),
              " mean  x\n"
              "-----  -\n"
              "1 ± 2  a\n");
}

TEST(Table, MissingCellsAreEmptyAndLinesDoNotEndInBlanks) {
    Table table({{"a", Table::Align::Left}, {"b", Table::Align::Left}});
    table.addRow({"1"});
    EXPECT_EQ(table.text(), "a  b\n-  -\n1\n");
}
