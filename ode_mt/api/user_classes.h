#pragma once

// To be called when upstream empties its table of colliders (first dInitODE2).
void dxForgetColliders();

// To be called when upstream forgets the user's geom classes as well (last dCloseODE).
void dxForgetUserClasses();
