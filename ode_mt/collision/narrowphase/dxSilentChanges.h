// Counter of changes to inputs of colliders without a notification of the space: samples of a height field, destroyed
// data of meshes or height fields, or the position of a body, which some functions of joints change and restore with
// rounding.
//
// Prefetched contacts are invalid if the callback, or an earlier one, has made such a change (dxNarrowphasePrefetch).
// Threading: any thread.
#pragma once

#include <atomic>
#include <cstdint>

namespace dxSilentChanges {

extern std::atomic<std::uint64_t> changes;

inline std::uint64_t count() { return changes.load(std::memory_order_acquire); }
inline void add() { changes.fetch_add(1, std::memory_order_acq_rel); }

}  // namespace dxSilentChanges
