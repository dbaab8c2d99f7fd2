// The page that shows what was measured and recorded: HTML, complete in itself.
#pragma once

#include <string>
#include <vector>

namespace report {

// Recordings as text that fits into a page: compressed (a sixth), and in letters that HTML leaves alone.
std::string gzip(const std::string &bytes);    // RFC 1952
std::string base64(const std::string &bytes);  // RFC 4648, section 4

// The page without data, written by bundle.py: sources in page/, three.js, Chart.js, their licences.
extern const char *const kEmptyPage;

struct NamedRecording {
    std::string name;   // as the page shows it
    std::string lines;  // as odemt_record has written it
    std::string otherWorld{};  // why it is not of the first recording's world, as a warning; empty: it is
};

// `results`: the text of the bench's JSON file; empty: none. Throws std::runtime_error if it is no such file.
std::string page(const std::string &results, const std::vector<NamedRecording> &recordings);

}  // namespace report
