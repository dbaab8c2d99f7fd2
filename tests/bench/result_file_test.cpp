// The names of the files that odemt_bench --trace writes.
#include "result_file.h"

#include <gtest/gtest.h>

namespace bench {

TEST(TraceFile, OneRunHasTheFileItself) {
    EXPECT_EQ(traceFileOf("a/trace.json", "create", "ours:2", 1), "a/trace.json");
    EXPECT_EQ(traceFileOf("", "create", "ours:2", 3), "");
}

TEST(TraceFile, SeveralHaveTheirNames) {
    EXPECT_EQ(traceFileOf("a/trace.json", "create", "ours:2", 2), "a/trace-create-ours-2.json");
    EXPECT_EQ(traceFileOf("trace", "pile:40,sap", "ours:auto/lcp/cells=8", 2), "trace-pile-40-sap-ours-auto-lcp-cells-8");
    EXPECT_EQ(traceFileOf("t.json", "my/world.sdf", "ours:0", 2), "t-world-ours-0.json");
}

}  // namespace bench
