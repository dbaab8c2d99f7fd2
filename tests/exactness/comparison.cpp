#include "comparison.h"

#include <algorithm>

namespace exactness {

namespace {

const char *const nothing = "nothing";

bool sameStage(const StageHash &a, const StageHash &b) { return a.step == b.step && a.stage == b.stage; }

bool sameField(const Value &a, const Value &b) {
    return a.stage == b.stage && a.object == b.object && a.field == b.field;
}

std::string whole(const Value &value) {
    std::string text = value.object + ", " + value.field;
    for (const Word &word : value.words) text += ' ' + toString(word);
    return value.text.empty() ? text : text + " \"" + value.text + '"';
}

std::string wordAt(const Value &value, std::size_t i) {
    return i < value.words.size() ? toString(value.words[i]) : nothing;
}

std::optional<Difference> differenceInField(int step, const Value &expected, const Value &actual) {
    const std::size_t count = std::max(expected.words.size(), actual.words.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::string a = wordAt(expected, i), b = wordAt(actual, i);
        if (a == b) continue;
        return Difference{
            step, expected.stage, expected.object, expected.field + '[' + std::to_string(i) + ']', a, b};
    }
    if (expected.text == actual.text) return std::nullopt;
    return Difference{step,
                      expected.stage,
                      expected.object,
                      expected.field,
                      '"' + expected.text + '"',
                      '"' + actual.text + '"'};
}

}  // namespace

std::optional<Divergence> firstDivergence(const Record &expected, const Record &actual) {
    const std::size_t common = std::min(expected.stages.size(), actual.stages.size());
    for (std::size_t i = 0; i < common; ++i) {
        const StageHash &a = expected.stages[i], &b = actual.stages[i];
        if (!sameStage(a, b) || a.hash != b.hash) return Divergence{a.step, a.stage};
    }
    if (expected.stages.size() == actual.stages.size()) return std::nullopt;
    const Record &longer = expected.stages.size() > common ? expected : actual;
    return Divergence{longer.stages[common].step, longer.stages[common].stage};
}

std::optional<Difference> firstDifference(int step, const Record &expected, const Record &actual) {
    const std::size_t common = std::min(expected.values.size(), actual.values.size());
    for (std::size_t i = 0; i < common; ++i) {
        const Value &a = expected.values[i], &b = actual.values[i];
        if (!sameField(a, b)) return Difference{step, a.stage, a.object, "kind", whole(a), whole(b)};
        if (auto difference = differenceInField(step, a, b)) return difference;
    }
    if (expected.values.size() == actual.values.size()) return std::nullopt;
    const bool missing = expected.values.size() > common;
    const Value &extra = missing ? expected.values[common] : actual.values[common];
    return Difference{step,
                      extra.stage,
                      extra.object,
                      extra.field,
                      missing ? whole(extra) : nothing,
                      missing ? nothing : whole(extra)};
}

std::string Difference::describe() const {
    return "step " + std::to_string(step) + ", stage '" + stage + "', " + object + ", " + field +
           "\n  libode8: " + expected + "\n  ODE_MT:  " + actual;
}

}  // namespace exactness
