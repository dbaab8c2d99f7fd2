#pragma once

// To be called when upstream forgets the user's geom classes (last dCloseODE).
void dxForgetUserClasses();
