// Properties of an island that must be known before it may be stepped on a worker. The island is unchanged. Threading:
// may run on a worker.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dynamics/step/islands/dxIsland.h"

// Returns whether a body of the island has a moved-callback. From such an island on, islands are stepped in order: the
// callback may change any of those that follow.
bool dxHasMovedCallback(const dxIsland &island);

// Rows of the island's constraint system, as the stepper will count them; none if a joint reports an error,
// which the step must report in order.
std::optional<unsigned> dxCountRows(const dxIsland &island);

struct dxFeedbackUse {
    std::uintptr_t feedback;  // address
    unsigned unit;  // that writes it: an island, or the world of one (dxDeferredRun)
};

// Requires that `first` does not begin behind `second`.
inline bool dxOverlap(const dxFeedbackUse &first, const dxFeedbackUse &second) {
    return second.feedback - first.feedback < sizeof(dJointFeedback);
}

// Appends the feedback structures that the island, which belongs to the unit, writes.
void dxCollectFeedback(const dxIsland &island, unsigned unit, std::vector<dxFeedbackUse> &uses);
