// Prefetches the bodies and joints of an island for a stage. An island's order follows its joints from body to body; in
// a heap that order is random in memory, and a heap's bodies and joints do not fit L2.
#pragma once

#include <algorithm>
#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/contact.h"
#include "core/dxPrefetch.h"

namespace dxIslandPrefetch {

// Number of bodies from which on a stage prefetches: a hundred bodies with their contacts are half a megabyte.
constexpr unsigned kMinBodies = 100;

constexpr std::size_t kDistance = 4;  // prefetch distance, and size of a chunk

// Prefetches what stages read of a body: all but the settings of automatic disabling and damping at its end.
inline void body(const dxBody *body) {
    const auto begin = reinterpret_cast<const char *>(body), end = reinterpret_cast<const char *>(&body->finite_rot_axis);
    dxPrefetch::linesForWrite(begin, static_cast<std::size_t>(end - begin));
}

// Prefetches a joint of any kind, by the size of a contact, the most frequent kind.
inline void joint(const dxJoint *joint) { dxPrefetch::lines(joint, sizeof(dxJointContact)); }

// Calls work(begin, end) for chunks of [begin, end) of at most kDistance items, after fetch(item) for those of the next
// chunk, which may be beyond `end` but below `count`.
template <class Prefetch, class Work>
void forChunks(std::size_t begin, std::size_t end, std::size_t count, const Prefetch &prefetch, const Work &work) {
    for (std::size_t chunk = begin; chunk < end; chunk += kDistance) {
        const std::size_t next = std::min(chunk + kDistance, count);
        for (std::size_t i = next; i < std::min(next + kDistance, count); ++i) prefetch(i);
        work(chunk, std::min(chunk + kDistance, end));
    }
}

}  // namespace dxIslandPrefetch
