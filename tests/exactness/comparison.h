// Finds and names the first difference between two records.
#pragma once

#include "record.h"

#include <optional>

namespace exactness {

// The first stage in which two runs differ, or nothing if they are equal.
struct Divergence {
    int step;
    std::string stage;
};
std::optional<Divergence> firstDivergence(const Record &expected, const Record &actual);

// "step 17, after step, body 12, linear velocity[1]: libode8 0.5 (3fe0...), ODE_MT 0.25 (3fd0...)".
struct Difference {
    int step;
    std::string stage;
    std::string object;
    std::string field;
    std::string expected;
    std::string actual;

    std::string describe() const;
};

// The first value that differs in the step that both records hold the values of. Nothing if all are
// equal.
std::optional<Difference> firstDifference(int step, const Record &expected, const Record &actual);

}  // namespace exactness
