// The page's text; what a browser makes of it is tested in tests/report.
#include "report/page.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <stdexcept>

using namespace report;

namespace {

std::string gunzip(const std::string &packed, std::size_t size) {
    z_stream stream{};
    inflateInit2(&stream, 15 + 16);
    std::string bytes(size + 1, '\0');
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef *>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    bytes.resize(stream.total_out);
    inflateEnd(&stream);
    return bytes;
}

}  // namespace

// The examples of RFC 4648, section 10.
TEST(Compression, Base64IsThatOfTheStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Compression, WhatIsCompressedComesBack) {
    std::string lines;
    for (int i = 0; i < 10'000; ++i) lines += "{\"frame\":" + std::to_string(i) + "}\n";
    const std::string packed = gzip(lines);
    EXPECT_LT(packed.size(), lines.size() / 4);
    EXPECT_TRUE(gunzip(packed, lines.size()) == lines);
    EXPECT_EQ(gunzip(gzip(""), 0), "");
}

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
