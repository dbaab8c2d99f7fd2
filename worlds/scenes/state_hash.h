// One number for the state of a scene: equal states, equal hashes.
#pragma once

#include "scenes/scene.h"

#include <cstdint>

namespace scenes {

// FNV-1a over the bits of position, quaternion, linear and angular velocity of all bodies in the
// order of the inventory, over whether each is enabled, and over the readings of sensors. Every NaN
// counts as the same NaN; +0 and -0 differ.
std::uint64_t stateHash(const Inventory &inventory);

}  // namespace scenes
