#include "engine.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace bench;

namespace {

std::vector<std::string> names(const std::vector<Engine> &engines) {
    std::vector<std::string> result;
    for (const Engine &engine : engines) result.push_back(engine.name());
    return result;
}

std::string complaint(const std::string &engine) {
    try {
        readEngine(engine);
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Engine, NamesAreReadAndWrittenBack) {
    for (const char *name : {"stock", "stock:/usr/lib/libode.so.8", "stock:a/b:c", "stock:2", "stock-pool:2", "ours:0", "ours:1024", "ours:auto",
                             "ours:2/openmp", "ours:2/lcp", "ours:2/pthread/lcp", "ours:2/concurrent", "ours:2/independent", "ours:2/cells=5",
                             "ours:0/fast", "ours:2/lcp/exact", "ours:auto/openmp/decluster/concurrent/cells=20"})
        EXPECT_EQ(readEngine(name).name(), name);
}

TEST(Engine, UnknownOnesAreNamedWithThoseThatExist) {
    EXPECT_NE(complaint("bullet").find("'bullet'"), std::string::npos);
    EXPECT_NE(complaint("bullet").find("stock-pool:N"), std::string::npos);
    EXPECT_NE(complaint("stock:").find("'stock:': no path"), std::string::npos);
    EXPECT_NE(complaint("stock/openmp").find("'stock/openmp'"), std::string::npos);
}

TEST(Engine, BadThreadCountsAreNamed) {
    for (const char *name :
         {"ours:-1", "ours:1025", "ours:two", "ours:", "ours:2x", "ours:01", "ours:1/cells=05", "stock-pool:0",
          "stock-pool:01", "stock-pool:auto"})
        EXPECT_NE(complaint(name).find(name), std::string::npos) << name;
}

TEST(Engine, BadGridsAreNamed) {
    for (const std::string cells : {"4", "21", "", "x", "8x"}) {
        const std::string name = "ours:2/decluster/cells=" + cells;
        EXPECT_NE(complaint(name).find("'" + cells + "' is not a number of grid cells from 5 to 20"),
                  std::string::npos);
        EXPECT_NE(complaint(name).find(name), std::string::npos);
    }
}

TEST(Engine, WordsMayComeInAnyOrder) {
    EXPECT_EQ(readEngine("ours:2/cells=8/concurrent/lcp/pthread").name(),
              "ours:2/pthread/lcp/concurrent/cells=8");
}

TEST(Engine, OnlyOursHasWords) {
    EXPECT_NE(complaint("stock/concurrent").find("'stock/concurrent'"), std::string::npos);
    EXPECT_NE(complaint("stock-pool:2/cells=8").find("'stock-pool:2/cells=8'"), std::string::npos);
}

TEST(Engine, EnvironmentOfOurs) {
    const std::map<std::string, std::string> expected = {
        {"ODE_MT_THREADS", "2"}, {"ODE_MT_THREAD_MANAGER", "openmp"}, {"ODE_MT_ALGORITHM", "lcp"}};
    EXPECT_EQ(readEngine("ours:2/openmp/lcp").environment(), expected);
    EXPECT_TRUE(readEngine("stock-pool:2").environment().empty());
    const std::map<std::string, std::string> cells = {
        {"ODE_MT_THREADS", "0"}, {"ODE_MT_CALLBACKS", "concurrent"}, {"ODE_MT_GRID_CELLS", "12"}};
    EXPECT_EQ(readEngine("ours:0/concurrent/cells=12").environment(), cells);
}

TEST(Engine, OnlyThePoolIsNotReproducible) {
    EXPECT_TRUE(readEngine("stock").isReproducible());
    EXPECT_TRUE(readEngine("ours:2").isReproducible());
    EXPECT_FALSE(readEngine("stock-pool:2").isReproducible());
    EXPECT_TRUE(readEngine("ours:2/fast").isReproducible());
    EXPECT_FALSE(readEngine("ours:2/fast").hasUpstreamsBits());
    EXPECT_TRUE(readEngine("ours:2/exact").hasUpstreamsBits());
    EXPECT_TRUE(readEngine("stock").hasUpstreamsBits());
    EXPECT_EQ(readEngine("ours:2/fast").environment().at("ODE_MT_SOLVER"), "fast");
}

TEST(Engine, ListsExpandOverThreads) {
    EXPECT_EQ(names(readEngines({"stock", "stock-pool", "ours"}, {"0", "4", "2"}, "")),
              (std::vector<std::string>{"stock", "stock-pool:4", "ours:0", "ours:4", "ours:2"}));
}

TEST(Engine, TheManagerOptionIsForThoseThatNameNone) {
    EXPECT_EQ(names(readEngines({"stock", "ours:1", "ours:2/pthread"}, {}, "openmp")),
              (std::vector<std::string>{"stock", "ours:1/openmp", "ours:2/pthread"}));
    EXPECT_THROW(readEngines({"ours:1"}, {}, "tbb"), std::invalid_argument);
}

TEST(Engine, ListsMustNameEachOnceAndAtLeastOne) {
    EXPECT_THROW(readEngines({"stock", "ours:1", "stock"}, {}, ""), std::invalid_argument);
    EXPECT_THROW(readEngines({}, {}, ""), std::invalid_argument);
    EXPECT_THROW(readEngines({"ours"}, {"many"}, ""), std::invalid_argument);
}

TEST(Engine, AnotherLibraryHasItsPathAndUpstreamsBits) {
    const Engine other = readEngine("stock:/a/b/libode.so.8.2.0");
    EXPECT_EQ(other.kind, Engine::Kind::Stock);
    EXPECT_EQ(other.path, "/a/b/libode.so.8.2.0");
    EXPECT_TRUE(other.hasUpstreamsBits());
    EXPECT_TRUE(other.environment().empty());
    EXPECT_EQ(readEngine("stock").path, "");
    EXPECT_EQ(names(readEngines({"stock", "stock:/a", "stock:/b", "ours:2"}, {}, "openmp")),
              (std::vector<std::string>{"stock", "stock:/a", "stock:/b", "ours:2/openmp"}));
    EXPECT_THROW(readEngines({"stock:/a", "stock:/a"}, {}, ""), std::invalid_argument);
    EXPECT_EQ(readEngine("stock:/a\x1b[31m").name(), "stock:/a\\x1b[31m");
}

TEST(Engine, UnknownAndDoubledWordsAreRefused) {
    EXPECT_NE(complaint("ours:1/foo").find("unknown word 'foo'; known: pthread, openmp"), std::string::npos);
    EXPECT_NE(complaint("ours:1/foo").find("static-unmerged"), std::string::npos);
    for (const char *name : {"ours:1/lcp/auto", "ours:1/lcp/lcp", "ours:1/pthread/openmp",
                             "ours:1/concurrent/independent", "ours:1/cells=5/cells=6"})
        EXPECT_NE(complaint(name).find("exclude one another"), std::string::npos) << name;
    for (const char *name : {"ours:1/", "ours:1//lcp", "ours:1/lcp/"})
        EXPECT_NE(complaint(name).find("unknown word ''"), std::string::npos) << name;
}
