// The page's text; what a browser makes of it is tested in tests/report.
#include "report/page.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

const std::string kResults = R"({"machine":{"cores":2,"processor":"a <b> & c"},"worlds":[{"world":"</script><script>x"}]})";

}  // namespace

TEST(ReportPage, HoldsTheResultsInOneElement) {
    const std::string page = report::page(kResults, {});
    EXPECT_NE(page.find("<script id=\"results\" type=\"application/json\">"), std::string::npos);
    EXPECT_NE(page.find("\\u003c/script>"), std::string::npos);
    EXPECT_EQ(page.find("</script><script>x"), std::string::npos);
    EXPECT_EQ(page.find("<!-- data -->"), std::string::npos);
}

TEST(ReportPage, HoldsRecordingsByName) {
    const std::string page = report::page("", {{"a\"b", "lines"}, {"second", "other lines"}});
    EXPECT_NE(page.find("data-name=\"a&quot;b\""), std::string::npos);
    EXPECT_NE(page.find("data-name=\"second\""), std::string::npos);
    EXPECT_EQ(page.find("id=\"results\""), std::string::npos);
}

TEST(ReportPage, HasTheLicencesOfWhatItContains) {
    const std::string page = report::kEmptyPage;
    for (const char *const name : {"three.js", "Chart.js", "Permission is hereby granted", "Redistribution and use in source and binary"})
        EXPECT_NE(page.find(name), std::string::npos) << name;
}

TEST(ReportPage, NothingIsLoadedFromElsewhere) {
    const std::string page = report::kEmptyPage;
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    for (const char *const attribute : {"src=\"http", "href=\"http", "@import", "url(http"})
        EXPECT_EQ(page.find(attribute), std::string::npos) << attribute;
}

TEST(ReportPage, OtherFilesAreNoResults) {
    for (const char *const text : {"no JSON", "[]", "{}", R"({"machine":{},"worlds":[]})", R"({"worlds":[{}]})"})
        EXPECT_THROW(report::page(text, {}), std::runtime_error) << text;
}
