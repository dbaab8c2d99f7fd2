// Islands that are stepped together, as if they were one.
//
// Threading: requires the thread that steps the world.
#pragma once

#include <algorithm>
#include <cstddef>

#include "joints/joint.h"

// A group ends when it has so many bodies and joints; 0: each island is its own.
struct dxGroupSizes {
    unsigned ofContacts = 0;  // islands that only contacts hold together
    unsigned ofJoints = 0;    // islands with other joints
};

// Follows the search for islands and tells where groups end. Islands of the two kinds are not mixed, and one that fills a group is alone.
class dxIslandGroups {
public:
    // The lists of what has been found.
    struct Lists {
        dxBody **bodies;
        dxJoint **joints;
    };

    dxIslandGroups(const dxGroupSizes &sizes, const Lists &lists) : m_sizes(sizes), m_begin(lists) {}

    // An island has been found, from `first` on. Calls end(begin of a group, end of it) for the group before it, if that does not go on, and
    // for its own, if that is full.
    template <class End>
    void take(const Lists &first, const Lists &last, const End &end) {
        const Kind kind = kindOf(first, last);
        if (kind != m_kind && !isEmpty(first)) endAt(first, end);
        m_kind = kind;
        if (sizeOf(m_begin, last) >= (kind == Kind::Joints ? m_sizes.ofJoints : m_sizes.ofContacts)) endAt(last, end);
    }

    // No more islands come.
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
