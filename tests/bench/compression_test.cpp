#include "report/compression.h"

#include <gtest/gtest.h>
#include <zlib.h>

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
