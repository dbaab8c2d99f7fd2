// What has to be known of an island before it may be stepped on a worker. Reads the island only, and may
// itself run on a worker.
#pragma once

#include <vector>

#include "dynamics/dxIsland.h"

// Whether the user wants to be called when a body of the island moves. From such an island on islands go
// in order: the callback may change any of those that follow.
bool dxHasMovedCallback(const dxIsland &island);

// Rows of the island's constraint system, as upstream's stepper will count them: getInfo1 depends on
// poses only and may be called twice.
unsigned dxCountRows(const dxIsland &island);

struct dxFeedbackUse {
    const void *feedback;
    unsigned island;
};

// Appends the feedback structures that the island writes.
void dxCollectFeedback(const dxIsland &island, unsigned index, std::vector<dxFeedbackUse> &uses);
