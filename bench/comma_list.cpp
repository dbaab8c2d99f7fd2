#include "comma_list.h"

namespace bench {

namespace {

bool isEscapedComma(const std::string &text, std::size_t at) { return text.compare(at, 2, "\\,") == 0; }

}  // namespace

std::vector<std::string> splitAtCommas(const std::string &list) {
    std::vector<std::string> words;
    bool hasEnded = true;  // a comma at the end begins no word
    for (std::size_t at = 0; at < list.size(); ++at) {
        if (hasEnded) words.emplace_back();
        hasEnded = list[at] == ',';
        if (hasEnded) continue;
        words.back() += list[at];
        if (isEscapedComma(list, at)) words.back() += list[++at];
    }
    return words;
}

std::string withoutEscapes(const std::string &word) {
    std::string text;
    for (std::size_t at = 0; at < word.size(); ++at) text += isEscapedComma(word, at) ? word[++at] : word[at];
    return text;
}

std::string joinWords(const std::vector<std::string> &words) {
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace bench
