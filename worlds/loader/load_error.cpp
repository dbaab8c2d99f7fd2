#include "loader/load_error.h"

#include <algorithm>

namespace worlds {

namespace {

constexpr std::size_t longestShown = 200;  // characters of a path or of quoted text

// Cut in the middle, never within a character of several bytes.
std::string shorten(const std::string &text) {
    if (text.size() <= longestShown) return text;
    const auto isInside = [&](std::size_t at) { return (text[at] & 0xc0) == 0x80; };
    std::size_t head = longestShown / 2, tail = text.size() - longestShown / 2;
    while (head > 0 && isInside(head)) --head;
    while (tail < text.size() && isInside(tail)) ++tail;
    return text.substr(0, head) + "..." + text.substr(tail);
}

}  // namespace

std::string printable(const std::string &text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool isSecondControl =  // U+0080 to U+009f
            byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
        if (byte >= 0x20 && byte != 0x7f && !isSecondControl) {
            shown += text[i];
            continue;
        }
        for (std::size_t last = i + (isSecondControl ? 1 : 0);; ++i) {
            const auto control = static_cast<unsigned char>(text[i]);
            shown += std::string("\\x") + digits[control >> 4] + digits[control & 15];
            if (i == last) break;
        }
    }
    return shown;
}

std::string quote(const std::string &text) { return "'" + shorten(text) + "'"; }

std::string toString(const Place &place) {
    return printable(place.path.empty() ? place.file : place.file + ": " + shorten(place.path));
}

}  // namespace worlds
