#include "check/state_difference.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace check {

namespace {

std::string realText(std::uint64_t bits) {
    double value;
    std::memcpy(&value, &bits, sizeof value);
    char text[64];
    std::snprintf(text, sizeof text, "%.17g (%016llx)", value, static_cast<unsigned long long>(bits));
    return text;
}

std::string text(const Field &field, std::uint64_t word) {
    if (field.isReal) return realText(word);
    if (std::strcmp(field.name, "stepper") == 0) return word == kWorldQuickStep ? "dWorldQuickStep" : "dWorldStep";
    return std::to_string(static_cast<std::int64_t>(word));
}

std::string nameOf(const Field &field, std::uint32_t word) {
    if (field.words == 1) return field.name;
    const char *const components = field.words == 4 ? "wxyz" : "xyz";
    return std::string(field.name) + ' ' + components[word];
}

template <class Fields>
void compareWords(const Fields &fields, const std::uint64_t *left, const std::uint64_t *right, std::optional<std::uint64_t> body,
                  std::vector<ValueDifference> &differences) {
    for (const Field &field : fields)
        for (std::uint32_t i = 0; i < field.words; ++i, ++left, ++right)
            if (*left != *right) differences.push_back({body, nameOf(field, i), text(field, *left), text(field, *right)});
}

bool areSame(const BodyState &left, const BodyState &right) {
    return left.number == right.number && std::equal(std::begin(left.words), std::end(left.words), std::begin(right.words));
}

void compareBodies(const StoredState &left, const StoredState &right, StateDifference &difference) {
    const std::size_t both = std::min(left.bodies.size(), right.bodies.size());
    for (std::size_t i = 0; i < both; ++i) {
        if (areSame(left.bodies[i], right.bodies[i])) continue;
        ++difference.differentBodies;
        if (!difference.values.empty()) continue;
        const std::uint64_t a = left.bodies[i].number, b = right.bodies[i].number;
        if (a != b)
            difference.values.push_back(
                {std::min(a, b), "existence", a < b ? "is there" : "is not there", a < b ? "is not there" : "is there"});
        else
            compareWords(kBodyFields, left.bodies[i].words, right.bodies[i].words, a, difference.values);
    }
}

}  // namespace

std::optional<StateDifference> compareStates(const StoredState &left, const StoredState &right) {
    StateDifference difference;
    difference.bodies = std::max(left.bodies.size(), right.bodies.size());
    compareWords(kStepFields, left.world.words, right.world.words, std::nullopt, difference.values);
    if (left.bodies.size() != right.bodies.size())
        difference.values.push_back(
            {std::nullopt, "number of bodies", std::to_string(left.bodies.size()), std::to_string(right.bodies.size())});
    compareBodies(left, right, difference);
    if (difference.values.empty()) return std::nullopt;
    return difference;
}

}  // namespace check
