#include "size_range.h"

#include <charconv>
#include <optional>

namespace bench {

namespace {

// Twice as much as any size that a world takes, so that doubling does not overflow.
constexpr long kLargest = 1'000'000'000;

std::optional<long> readNumber(const std::string &text) {
    long number = 0;
    const char *end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stopped != end || number < 1 || number > kLargest) return std::nullopt;
    return number;
}

}  // namespace

std::vector<std::string> expandSizes(const std::string &world) {
    const std::size_t comma = world.find(','), colon = world.substr(0, comma).rfind(':');
    if (colon == std::string::npos) return {world};
    const std::string name = world.substr(0, colon + 1),
                      modifiers = comma < world.size() ? world.substr(comma) : "",
                      size = world.substr(colon + 1, comma < world.size() ? comma - colon - 1 : comma);
    const std::size_t dots = size.find("..");
    if (dots == std::string::npos) return {world};
    const std::optional<long> first = readNumber(size.substr(0, dots)),
                              last = readNumber(size.substr(dots + 2));
    if (!first || !last || *first > *last) return {world};
    std::vector<std::string> worlds;
    for (long n = *first; n <= *last; n *= 2) worlds.push_back(name + std::to_string(n) + modifiers);
    return worlds;
}

}  // namespace bench
