// Asks the memory for the bodies and joints of an island before a stage comes to them. An island's order follows its
// joints from body to body; in a heap, that is anywhere in memory, and a heap's bodies and joints do not fit the caches
// close to the core.
#pragma once

#include <algorithm>
#include <cstddef>

#include "config.h"
#include "objects.h"
#include "joints/contact.h"
#include "core/dxFetch.h"

namespace dxFetchAhead {

// Bodies from which on a stage asks ahead: a hundred bodies with their contacts are half a megabyte.
constexpr unsigned kLeastBodies = 100;

constexpr std::size_t kItems = 4;  // that are worked on while the next ones are on their way

// What stages read: all but the settings at the end, of automatic disabling and damping.
inline void body(const dxBody *body) {
    const auto begin = reinterpret_cast<const char *>(body), end = reinterpret_cast<const char *>(&body->finite_rot_axis);
    dxFetch::linesToWrite(begin, static_cast<std::size_t>(end - begin));
}

// A joint of any kind: contacts are the ones of which there are many.
inline void joint(const dxJoint *joint) { dxFetch::lines(joint, sizeof(dxJointContact)); }

// Calls work(begin, end) for pieces of [begin, end) of kItems items at most, after fetch(item) for those of the piece
// after it, which may lie beyond `end` but not at `count` or behind.
template <class Fetch, class Work>
void forPieces(std::size_t begin, std::size_t end, std::size_t count, const Fetch &fetch, const Work &work) {
    for (std::size_t piece = begin; piece < end; piece += kItems) {
        const std::size_t next = std::min(piece + kItems, count);
        for (std::size_t i = next; i < std::min(next + kItems, count); ++i) fetch(i);
        work(piece, std::min(piece + kItems, end));
    }
}

}  // namespace dxFetchAhead
