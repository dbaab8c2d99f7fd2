// Where to put the grid: around what moves. Static geoms do not stretch it, and neither do a few strays.
#pragma once

#include "clusters/dxClusterGrid.h"
#include "clusters/dxClusterScene.h"

// A grid of `cells` cells an axis around the dynamic inhabitants, with room to move.
dxClusterGrid dxFitGrid(const dxClusterScene &scene, int cells);

// Share of the dynamic inhabitants that are outside the grid.
double dxShareOutside(const dxClusterScene &scene);

// So many dynamic inhabitants are outside that the grid should be placed anew.
bool dxGridIsOutgrown(const dxClusterScene &scene);
