#include "report/compression.h"

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace report {

std::string gzip(const std::string &bytes) {
    constexpr int kLargestWindow = 15, kGzipHeader = 16, kMemoryLevel = 8;  // zlib's own words for them
    if (bytes.size() > std::numeric_limits<uInt>::max()) throw std::runtime_error("more than 4 GB");
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kLargestWindow + kGzipHeader, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("no memory to compress with");
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));  // zlib does not write to it
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef *>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);  // in one go: the bound is large enough
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string base64(const std::string &bytes) {
    static const char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = i; j < i + 3; ++j) three = three << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
        for (int letter = 0; letter < 4; ++letter)
            text += i + static_cast<std::size_t>(letter) <= bytes.size() ? kLetters[three >> (18 - 6 * letter) & 63] : '=';
    }
    return text;
}

}  // namespace report
