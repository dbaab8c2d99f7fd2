#include "report/page.h"

#include "report/compression.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace report {

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
