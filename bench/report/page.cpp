#include "report/page.h"

#include <zlib.h>

#include <nlohmann/json.hpp>

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

using nlohmann::json;

namespace {

const std::string kPlaceholder = "<!-- data -->";

void replaceAll(std::string &text, const std::string &what, const std::string &by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, what.size(), by);
}

// Inside a script element only "</script" and "<!--" have a meaning; JSON, which has "<" in strings only, may spell it in another way.
std::string resultsElement(const std::string &results) {
    const json parsed = json::parse(results, nullptr, false);
    if (!parsed.is_object() || !parsed.contains("worlds") || !parsed["worlds"].is_array() || parsed["worlds"].empty() ||
        !parsed.contains("machine"))
        throw std::runtime_error("no results of odemt_bench");
    std::string text = results;
    replaceAll(text, "<", "\\u003c");
    return "<script id=\"results\" type=\"application/json\">" + text + "</script>\n";
}

std::string attribute(std::string text) {
    replaceAll(text, "&", "&amp;");
    replaceAll(text, "\"", "&quot;");
    replaceAll(text, "<", "&lt;");
    return text;
}

std::string recordingElement(const NamedRecording &recording) {
    return "<script class=\"recording\" type=\"text/plain\" data-name=\"" + attribute(recording.name) + "\" data-other-world=\"" +
           attribute(recording.otherWorld) + "\">" +
           base64(gzip(recording.lines)) + "</script>\n";
}

}  // namespace

std::string page(const std::string &results, const std::vector<NamedRecording> &recordings) {
    std::string data;
    if (!results.empty()) data += resultsElement(results);
    for (const NamedRecording &recording : recordings) data += recordingElement(recording);
    std::string page = kEmptyPage;
    return page.replace(page.find(kPlaceholder), kPlaceholder.size(), data);
}

}  // namespace report
