#include "collision/narrowphase/dxTurnedGeom.h"

#include "collision/pairs/dxMissedNotifications.h"

namespace dxTurnedGeom {

thread_local unsigned begun = 0;

void tell() {
    begun = 0;
    dxMissedNotifications::add();
}

// Those that began later were left by a jump into this one, or have been reported.
void end(unsigned collision) {
    if (begun != collision) tell();
    if (begun != 0) begun = collision - 1;
}

}  // namespace dxTurnedGeom
