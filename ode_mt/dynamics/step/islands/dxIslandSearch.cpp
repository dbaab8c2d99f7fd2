#include "dynamics/step/islands/dxIslandSearch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "settings/dxJointAttachment.h"
#include "core/dxPrefetch.h"
#include "joints/joint.h"
#include "upstream_facts.h"

namespace {

// Upstream's tags, beside dxFoundTag.
enum Tag : int { kUnfit = -1, kUnseen = 0, kFound = dxFoundTag };

// Returns the probable address of the object kPrefetchDistance places further on in a list. Most objects of a list were made one after another, so
// the distance to the next one tells. The address is not known, as a list is followed from object to object.
template <class Object>
std::uintptr_t predictedAddress(const Object *object) {
    constexpr std::uintptr_t kPrefetchDistance = 8;
    const auto here = reinterpret_cast<std::uintptr_t>(object), next = reinterpret_cast<std::uintptr_t>(object->next);
    return here + kPrefetchDistance * (next - here);
}

template <class Object, class Member>
void prefetchAhead(const Object *object, const Member &member) {
    const auto offset = reinterpret_cast<std::uintptr_t>(&member) - reinterpret_cast<std::uintptr_t>(object);
    dxPrefetch::line(reinterpret_cast<const void *>(predictedAddress(object) + offset));
}

// Prefetches what the search reads of bodies and joints, which fits L2. Returns whether a body has a moved-callback, if the caller asks for that: it
// needs one more cache line of each body.
bool untagBodies(dxWorld *world, bool asksForCallbacks) {
    bool hasCallback = false;
    for (dxBody *body = world->firstbody; body != nullptr; body = static_cast<dxBody *>(body->next)) {
        prefetchAhead(body, body->tag);
        prefetchAhead(body, body->flags);
        prefetchAhead(body, body->invMass);
        body->tag = kUnseen;
        if (!asksForCallbacks) continue;
        prefetchAhead(body, body->moved_callback);
        hasCallback |= body->moved_callback != nullptr;
    }
    return hasCallback;
}

void untagJoints(dxWorld *world) {
    for (dxJoint *joint = world->firstjoint; joint != nullptr; joint = static_cast<dxJoint *>(joint->next)) {
        prefetchAhead(joint, joint->tag);
        prefetchAhead(joint, joint->node[1]);
        joint->tag = kUnseen;
        dxJointAttachment::forget(*joint);
    }
    dxJointAttachment::forgetAll(*world);
}

// dxJoint::isEnabled as seen from one of the joint's bodies: a joint is enabled if one of them can move, and mostly
// this one can.
bool isEnabled(const dxJoint &joint, const dxBody &body) {
    return body.invMass > 0 ? (joint.flags & dJOINT_DISABLED) == 0 : joint.isEnabled();
}

// Finds where groups end during the search. Islands of the two kinds are not mixed, and an island that fills a group is alone.
class Groups {
public:
    // The lists of bodies and joints that have been found.
    struct Lists {
        dxBody **bodies;
        dxJoint **joints;
    };

    Groups(const dxGroupSizes &sizes, const Lists &lists) : m_sizes(sizes), m_begin(lists) {}

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

// Lists of one island after another, and the bodies from which the search will continue.
class Search {
public:
    Search(dxBody **bodies, dxJoint **joints, dxBody **open) : m_bodies(bodies), m_joints(joints), m_open(open) {}

    // Depth first, the body found last before those found earlier.
    void findIslandOf(dxBody *first) {
        first->tag = kFound;
        *m_bodies++ = first;
        dxBody **const none = m_open;
        for (dxBody *body = first;; *m_bodies++ = body) {
            follow(*body);
            if (m_open == none) return;
            body = *--m_open;
        }
    }

    Groups::Lists lists() const { return {m_bodies, m_joints}; }

private:
    void follow(const dxBody &body) {
        for (const dxJointNode *node = body.firstjoint; node != nullptr; node = node->next) {
            if (node->next != nullptr) prefetchAfter(*node);
            dxJoint *const joint = node->joint;
            if (joint->tag != kUnseen) continue;
            const bool enabled = isEnabled(*joint, body);
            joint->tag = enabled ? kFound : kUnfit;
            if (!enabled) continue;
            *m_joints++ = joint;
            if (node->body != nullptr && node->body->tag <= kUnseen) open(node->body);
        }
    }

    // The contacts of two bodies mostly were made one after another.
    static void prefetchAfter(const dxJointNode &node) {
        const auto here = reinterpret_cast<std::uintptr_t>(&node), next = reinterpret_cast<std::uintptr_t>(node.next);
        constexpr std::uintptr_t kPrefetchDistance = 2;
        dxPrefetch::line(reinterpret_cast<const void *>(here + kPrefetchDistance * (next - here)));
    }

    // A body at rest wakes when it is joined to one that moves.
    void open(dxBody *body) {
        body->tag = kFound;
        body->flags &= ~dxBodyDisabled;
        *m_open++ = body;
        dxPrefetch::line(body->firstjoint);
    }

    dxBody **m_bodies;
    dxJoint **m_joints;
    dxBody **m_open;
};

// Returns the memory that dxFindIslands takes: for sizes and lists of the islands, and for the bodies from which the search will continue.
sizeint searchMemory(const dxWorld &world) {
    const auto bodies = static_cast<sizeint>(world.nb), joints = static_cast<sizeint>(world.nj);
    const sizeint bodyList = dEFFICIENT_SIZE(bodies * sizeof(dxBody *)), jointList = dEFFICIENT_SIZE(joints * sizeof(dxJoint *));
    return dEFFICIENT_SIZE(2 * bodies * sizeof(unsigned)) + bodyList + jointList + std::min(bodyList, jointList);
}

// Upstream keeps the call for an island in the arena, too, and with it the call of the step, the island's number and the
// arena with its state.
constexpr sizeint kIslandCallSize = dEFFICIENT_SIZE(3 * sizeof(void *) + sizeof(sizeint) + sizeof(dxStepperProcessingCallContext));

// The arena of islands is as large as needed, whatever the user's reserve for steppers.
constexpr float kNoReserve = 1;

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
                      dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes) {
    const bool hasCallback = untagBodies(world, groupSizes.ofContacts != 0);
    dInternalHandleAutoDisabling(world, stepSize);
    untagJoints(world);

    const auto bodyCount = static_cast<unsigned>(world->nb), jointCount = static_cast<unsigned>(world->nj);
    unsigned *const sizes = arena->AllocateArray<unsigned>(std::size_t{2} * bodyCount);
    dxBody **const bodies = arena->AllocateArray<dxBody *>(bodyCount);
    dxJoint **const joints = arena->AllocateArray<dxJoint *>(jointCount);
    void *const state = arena->SaveState();
    // A body is put there when a joint is found, once.
    Search search(bodies, joints, arena->AllocateArray<dxBody *>(std::min(bodyCount, jointCount)));

    sizeint most = 0;
    unsigned *size = sizes;
    using Lists = Groups::Lists;
    // A callback may push bodies of islands that are not stepped yet.
    Groups groups(hasCallback ? dxGroupSizes() : groupSizes, search.lists());
    const auto endGroup = [&](const Lists &begin, const Lists &end) {
        *size++ = static_cast<unsigned>(end.bodies - begin.bodies);
        *size++ = static_cast<unsigned>(end.joints - begin.joints);
        most = std::max(most, estimate(begin.bodies, size[-2], begin.joints, size[-1]));
    };
    for (dxBody *body = world->firstbody; body != nullptr; body = static_cast<dxBody *>(body->next)) {
        if (body->tag != kUnseen) continue;
        if ((body->flags & dxBodyDisabled) != 0) {
            body->tag = kUnfit;
            continue;
        }
        const Lists first = search.lists();
        search.findIslandOf(body);
        groups.take(first, search.lists(), endGroup);
    }
    groups.finish(search.lists(), endGroup);
    arena->RestoreState(state);
    info.AssignInfo(static_cast<sizeint>(size - sizes) / 2, sizes, bodies, joints);
    return most;
}

}  // namespace

bool dxPrepareStep(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate) {
    return dxPrepareGroups(world, info, stepSize, estimate, {});
}

bool dxPrepareGroups(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes) {
    dxStepWorkingMemory *const memory = AllocateOnDemand(world->wmem);
    if (memory == nullptr) return false;
    dxWorldProcessContext *const context = memory->SureGetWorldProcessingContext();
    if (context == nullptr || !context->EnsureStepperSyncObjectsAreAllocated(world)) return false;

    const dxWorldProcessMemoryReserveInfo &reserve = *memory->SureGetMemoryReserveInfo();
    const dxWorldProcessMemoryManager *const manager = memory->SureGetMemoryManager();
    dxWorldProcessMemArena *const islands =
        context->ReallocateIslandsMemArena(searchMemory(*world), manager, kNoReserve, reserve.m_uiReserveMinimum);
    if (islands == nullptr) return false;

    const sizeint stepper = dxFindIslands(info, islands, world, stepSize, estimate, groupSizes);
    return context->ReallocateStepperMemArenas(world, dxIslandThreads(*world),
                                               stepper + kIslandCallSize, manager, reserve.m_fReserveFactor,
                                               reserve.m_uiReserveMinimum);
}
