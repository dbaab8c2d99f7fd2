// Velocities of an island's bodies while its constraints are solved. One cache line a body (in double precision), since every
// manifold reads and writes those of its two bodies.
#pragma once

#include "dynamics/step/islands/dxIslandProblem.h"

// Linear, then angular. The line is shared with the sweep over rows (dxSorSweep), to which a velocity is as good as an
// acceleration.
using dxVelocity = dxBodyAcceleration;
