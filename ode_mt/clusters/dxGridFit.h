// Placement of the grid around the dynamic geoms (thesis 10.1: the grid's centre). Static geoms do not enlarge it, and
// neither do a few outliers.
#pragma once

#include "clusters/dxClusterGrid.h"
#include "clusters/dxClusterScene.h"

// A grid of `cells` cells an axis around the dynamic inhabitants, with room to move.
dxClusterGrid dxFitGrid(const dxClusterScene &scene, int cells);

// Share of the dynamic inhabitants that are outside the grid.
double dxShareOutside(const dxClusterScene &scene);

// So many dynamic inhabitants are outside that the grid should be placed anew.
bool dxGridIsOutgrown(const dxClusterScene &scene);
