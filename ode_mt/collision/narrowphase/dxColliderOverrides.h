// The colliders that are the user's (dSetColliderOverride). They run on the user's thread alone.
//
// The set is process-wide, like upstream's table of colliders.
#pragma once

namespace dxColliderOverrides {

void note(int type1, int type2);  // in both orders
bool has(int type1, int type2);
void forget();

}  // namespace dxColliderOverrides
