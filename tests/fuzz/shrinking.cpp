#include "shrinking.h"

#include <algorithm>
#include <cmath>

namespace fuzz {

namespace {

using Test = std::function<bool(const Script &)>;

// Runs of calls, long ones first, from the back: what comes last needs what came before.
bool dropCalls(Script &script, const Test &isInteresting) {
    bool hasChanged = false;
    for (std::size_t length = std::max<std::size_t>(1, script.size() / 2); length > 0; length /= 2) {
        for (std::size_t end = script.size(); end > 0;) {
            const std::size_t begin = end > length ? end - length : 0;
            Script shorter(script.begin(), script.begin() + static_cast<std::ptrdiff_t>(begin));
            shorter.insert(shorter.end(), script.begin() + static_cast<std::ptrdiff_t>(end), script.end());
            if (isInteresting(shorter)) {
                script = std::move(shorter);
                hasChanged = true;
            }
            end = std::min(begin, script.size());
        }
    }
    return hasChanged;
}

bool simplifyNumber(Script &script, double &number, const Test &isInteresting) {
    const double former = number;
    for (const double simple : {0.0, 1.0, std::trunc(former), std::round(former * 8) / 8}) {
        if (simple == former || std::isnan(simple)) continue;
        number = simple;
        if (isInteresting(script)) return true;
    }
    number = former;
    return false;
}

bool simplifyNumbers(Script &script, const Test &isInteresting) {
    bool hasChanged = false;
    for (Call &call : script)
        for (Argument &argument : call.arguments)
            for (double &number : argument.numbers) hasChanged = simplifyNumber(script, number, isInteresting) || hasChanged;
    return hasChanged;
}

}  // namespace

Script shrink(Script script, const Test &isInteresting) {
    while (dropCalls(script, isInteresting)) {
    }
    for (int round = 0; round < 3 && simplifyNumbers(script, isInteresting); ++round) {
    }
    while (dropCalls(script, isInteresting)) {
    }
    return script;
}

}  // namespace fuzz
