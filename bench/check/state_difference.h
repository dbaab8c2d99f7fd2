// Which fields differ between two states of a world.
#pragma once

#include <optional>

#include "check/run_record.h"

namespace check {

struct ValueDifference {
    std::optional<std::uint64_t> body;  // its number; empty: the world's own
    std::string field;                  // "position y", "step size"
    std::string left, right;            // "0.5 (3fe0000000000000)"
};

struct StateDifference {
    std::vector<ValueDifference> values;  // of the first body that differs, or of the world
    std::uint64_t differentBodies = 0, bodies = 0;
};

// Empty: the states are the same.
std::optional<StateDifference> compareStates(const StoredState &left, const StoredState &right);

}  // namespace check
