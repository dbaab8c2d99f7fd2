// What has to be known of an island before it may be stepped on a worker. Leaves the island as it was, and
// may itself run on a worker.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/islands/dxIsland.h"

// Whether the user wants to be called when a body of the island moves. From such an island on islands go
// in order: the callback may change any of those that follow.
bool dxHasMovedCallback(const dxIsland &island);

// Rows of the island's constraint system, as upstream's stepper will count them; none if a joint reports an
// error, which the step has to report in its turn.
std::optional<unsigned> dxCountRows(const dxIsland &island);

struct dxFeedbackUse {
    const void *feedback;
    unsigned island;
};

// Appends the feedback structures that the island writes.
void dxCollectFeedback(const dxIsland &island, unsigned index, std::vector<dxFeedbackUse> &uses);
