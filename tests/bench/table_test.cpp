#include "table.h"

#include <gtest/gtest.h>

using namespace bench;

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
