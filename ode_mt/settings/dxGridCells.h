// How fine the grid of clusters may be, in cells on each axis (thesis 10.2): what settings accept and grids have.
#pragma once

constexpr int dxMinGridCells = 5, dxMaxGridCells = 20;
