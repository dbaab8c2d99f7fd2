// How often the data of a height field has changed, of any in the process.
//
// Contacts that were computed ahead of a near-callback are void if the callback, or one before it, has
// changed the samples that they were computed from (dxContactsAhead). Any thread.
#pragma once

#include <atomic>
#include <cstdint>

namespace dxHeightRevision {

extern std::atomic<std::uint64_t> changes;

inline std::uint64_t count() { return changes.load(std::memory_order_acquire); }
inline void add() { changes.fetch_add(1, std::memory_order_acq_rel); }

}  // namespace dxHeightRevision
