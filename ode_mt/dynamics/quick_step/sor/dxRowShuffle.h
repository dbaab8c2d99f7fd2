// QuickStep's shuffle of an island's rows.
#pragma once

// Sweeps between two shuffles; upstream shuffles before every eighth sweep but the first.
constexpr unsigned kShuffleInterval = 8;

// Swaps every entry but the first with a random one before it or itself, in ascending order. Draws rows - 1 numbers as
// one block: from the island's own part of the random sequence, or from the shared one.
void dxShuffleRows(int *order, unsigned rows);
