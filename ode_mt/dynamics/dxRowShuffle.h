// QuickStep's shuffle of an island's rows (ode/seams/quickstep.h puts it in the place of upstream's).
#pragma once

// Swaps every entry but the first with a random one before it or itself, in ascending order. Draws rows - 1 numbers, all
// at once: from the island's own piece of the random sequence, or from the shared one.
void dxShuffleRows(int *order, unsigned rows);
