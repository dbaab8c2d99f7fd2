#include "support/text.h"

#include <cstdint>
#include <sstream>

namespace support {

namespace {

bool isEscapedComma(const std::string &text, std::size_t at) { return text.compare(at, 2, "\\,") == 0; }

constexpr std::size_t kMaxShown = 200;  // characters of a path or of quoted text

struct Character {
    std::uint32_t code;  // 0 for a byte that is no UTF-8
    std::size_t bytes;
};

Character characterAt(const std::string &text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() - at < bytes) return {0, 1};
    std::uint32_t code = first & (0xffu >> (bytes + 1));
    for (std::size_t i = at + 1; i < at + bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {0, 1};
        code = code << 6 | (byte(i) & 0x3f);
    }
    const bool isLonger = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
    const bool isOutside = code > 0x10ffff || (code >= 0xd800 && code < 0xe000);
    return {isLonger || isOutside ? 0 : code, isLonger || isOutside ? 1 : bytes};
}

// No control character, and nothing that ends a line or changes the direction of the text that follows.
bool isShown(std::uint32_t code) {
    const auto within = [&](std::uint32_t first, std::uint32_t last) {
        return code >= first && code <= last;
    };
    return code >= 0x20 && !within(0x7f, 0x9f) && code != 0x61c && !within(0x200e, 0x200f) &&
           !within(0x2028, 0x202e) && !within(0x2066, 0x2069) && code != 0xfeff;
}

}  // namespace

std::vector<std::string> split(const std::string &text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

std::vector<std::string> splitAtBlanks(const std::string &text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

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

std::string join(const std::vector<std::string> &words, const std::string &separator) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : separator) + words[i];
    return text;
}

std::string doubleQuoted(const std::string &text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csvField(const std::string &text) { return text.find_first_of(",\"\r\n") == std::string::npos ? text : doubleQuoted(text); }

// Cut in the middle, never within a character of several bytes.
std::string shortened(const std::string &text) {
    if (text.size() <= kMaxShown) return text;
    const auto isInside = [&](std::size_t at) { return (text[at] & 0xc0) == 0x80; };
    std::size_t head = kMaxShown / 2, tail = text.size() - kMaxShown / 2;
    while (head > 0 && isInside(head)) --head;
    while (tail < text.size() && isInside(tail)) ++tail;
    return text.substr(0, head) + "..." + text.substr(tail);
}

std::string printable(const std::string &text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string shown;
    for (std::size_t i = 0; i < text.size();) {
        const Character character = characterAt(text, i);
        for (const std::size_t end = i + character.bytes; i < end; ++i) {
            const auto byte = static_cast<unsigned char>(text[i]);
            if (isShown(character.code))
                shown += text[i];
            else
                shown += std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
        }
    }
    return shown;
}

std::string quote(const std::string &text) { return "'" + shortened(text) + "'"; }

}  // namespace support
