#include "collision/narrowphase/dxTransformedGeom.h"

#include "collision/pairs/dxUnnoticedChanges.h"

namespace dxTransformedGeom {

thread_local unsigned begun = 0;
std::atomic<bool> hasEverBegun{false};

void tell() {
    begun = 0;
    dxMissedNotifications.add();
}

// Those that began later were left by a jump into this one, or have been reported.
void end(unsigned collision) {
    if (begun != collision) tell();
    if (begun != 0) begun = collision - 1;
}

}  // namespace dxTransformedGeom
