// How often something has changed that contacts are computed from, and of which no space is told: samples of a height field,
// data of meshes or height fields that has been destroyed, or the position of a body, which some functions of joints move to and fro, so that it comes back rounded.
//
// Contacts that were computed ahead of a near-callback are void if the callback, or one before it, has made such a
// change (dxContactsAhead). Any thread.
#pragma once

#include <atomic>
#include <cstdint>

namespace dxSilentChanges {

extern std::atomic<std::uint64_t> changes;

inline std::uint64_t count() { return changes.load(std::memory_order_acquire); }
inline void add() { changes.fetch_add(1, std::memory_order_acq_rel); }

}  // namespace dxSilentChanges
