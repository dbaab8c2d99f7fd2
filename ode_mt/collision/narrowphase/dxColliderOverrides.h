// Which colliders are the user's (dSetColliderOverride): code that runs on the user's thread alone.
//
// For the process, as upstream's table of colliders is.
#pragma once

namespace dxColliderOverrides {

void note(int type1, int type2);  // in either order
bool has(int type1, int type2);
void forget();

}  // namespace dxColliderOverrides
