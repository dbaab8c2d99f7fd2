// Prepares a step, for all steppers: searches for islands (bodies that enabled joints connect) in upstream's order
// (BuildIslandsAndEstimateStepperMemoryRequirements in util.cpp), and takes working memory.
//
// Threading: requires the thread that steps the world.
#pragma once

#include <algorithm>
#include <cstddef>

#include "dynamics/step/islands/dxIsland.h"

// Sizes of groups: islands that are stepped together, as if they were one. A group ends when it has this many bodies and joints; 0: each island is
// its own.
struct dxGroupSizes {
    unsigned ofContacts = 0;  // islands that only contacts hold together
    unsigned ofJoints = 0;    // islands with other joints
};

// Finds where groups end during the search. Islands of the two kinds are not mixed, and an island that fills a group is alone.
class dxIslandGroups {
public:
    // The lists of bodies and joints that have been found.
    struct Lists {
        dxBody **bodies;
        dxJoint **joints;
    };

    dxIslandGroups(const dxGroupSizes &sizes, const Lists &lists) : m_sizes(sizes), m_begin(lists) {}

    // Called when an island has been found, from `first` on. Calls end(begin of a group, end of it) for the group before it, if that ends here, and
    // for its own, if that is full.
    template <class End>
    void take(const Lists &first, const Lists &last, const End &end) {
        const Kind kind = kindOf(first, last);
        if (kind != m_kind && !isEmpty(first)) endAt(first, end);
        m_kind = kind;
        if (sizeOf(m_begin, last) >= (kind == Kind::Joints ? m_sizes.ofJoints : m_sizes.ofContacts)) endAt(last, end);
    }

    // Called after the last island.
    template <class End>
    void finish(const Lists &last, const End &end) {
        if (!isEmpty(last)) endAt(last, end);
    }

private:
    enum class Kind { Contacts, Joints, Full };

    static std::size_t sizeOf(const Lists &first, const Lists &last) {
        return static_cast<std::size_t>(last.bodies - first.bodies) + static_cast<std::size_t>(last.joints - first.joints);
    }

    Kind kindOf(const Lists &first, const Lists &last) const {
        if (sizeOf(first, last) >= m_sizes.ofContacts) return Kind::Full;
        const auto isOther = [](const dxJoint *joint) { return joint->type() != dJointTypeContact; };
        return std::any_of(first.joints, last.joints, isOther) ? Kind::Joints : Kind::Contacts;
    }

    bool isEmpty(const Lists &last) const { return last.bodies == m_begin.bodies; }

    template <class End>
    void endAt(const Lists &last, const End &end) {
        end(m_begin, last);
        m_begin = last;
    }

    dxGroupSizes m_sizes;
    Lists m_begin;
    Kind m_kind = Kind::Full;
};

constexpr int dxFoundTag = 1;  // of bodies and joints in islands

// Disables bodies at rest, finds the islands of the others, and returns the maximum memory that the stepper needs for
// an island.
//
//   info      gets the islands, which lie in the arena
//   estimate  the stepper's own estimate, called for each island
//   groupSizes  of groups, which then stand for islands
//
// Afterwards a body or joint in an island has dxFoundTag, all others a tag of 0 or
// below.
sizeint dxFindIslands(dxWorldProcessIslandsInfo &info, dxWorldProcessMemArena *arena, dxWorld *world, dReal stepSize,
                      dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes);

// Replaces dxReallocateWorldProcessContext (util.cpp), with the same effect (the seam is dxPrepareStepIslands):
// the user's memory manager is asked for blocks of the same sizes in the same order, and `info` gets upstream's islands.
//
//   estimate  the stepper's own estimate of the memory that it needs for an island
//
// Returns false if there is no memory.
bool dxPrepareStep(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate);

// The same for groups of islands, which are then stepped as if each were one island.
bool dxPrepareGroups(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes);
