#include "dynamics/step/dxJointRemoval.h"

#include <new>
#include <vector>

#include "core/dxPrefetch.h"
#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"

#include "config.h"
#include "joints/joint.h"
#include "objects.h"

namespace {

// Prefetch distances for a joint, and for its bodies. Units: joints.
constexpr std::size_t kPrefetchDistance = 8, kBodyPrefetchDistance = 4;

dxProcessObject<dxObjectPool<std::vector<dxJoint *>>> lists;

void removeFromBody(dxBody *body, const dxJoint *joint) {
    for (dxJointNode **link = &body->firstjoint; *link != nullptr; link = &(*link)->next)
        if ((*link)->joint == joint) {
            *link = (*link)->next;
            return;
        }
}

void removeFromWorld(dxJoint *joint) {
    for (const dxJointNode &node : joint->node)
        if (node.body != nullptr) removeFromBody(node.body, joint);
    // Not before: the list of either body runs through the node that names the other one.
    for (dxJointNode &node : joint->node) {
        node.body = nullptr;
        node.next = nullptr;
    }
    if (joint->next != nullptr) joint->next->tome = joint->tome;
    *joint->tome = joint->next;
    joint->next = nullptr;
    joint->tome = nullptr;
    --joint->world->nj;
}

void prefetch(const dxJoint *joint) {
    dxPrefetch::lineForWrite(&joint->world);
    dxPrefetch::lineForWrite(&joint->node[1]);
}

void prefetchBodies(const dxJoint *joint) {
    for (const dxJointNode &node : joint->node)
        if (node.body != nullptr) dxPrefetch::lineForWrite(&node.body->firstjoint);
}

void remove(dxJoint *joint) {
    if (joint->world != nullptr) removeFromWorld(joint);  // else its world has gone before it
    joint->~dxJoint();
}

}  // namespace

bool dxRemoveJoints(dxJointGroup &group) try {
    const std::size_t count = group.getJointCount();
    if (count == 0) return true;
    const dxPooledObject<std::vector<dxJoint *>> lease(*lists);
    std::vector<dxJoint *> &list = *lease;
    list.resize(count);
    group.exportJoints(list.data());
    for (std::size_t i = count; i-- != 0;) {
        if (i >= kPrefetchDistance) prefetch(list[i - kPrefetchDistance]);
        if (i >= kBodyPrefetchDistance) prefetchBodies(list[i - kBodyPrefetchDistance]);
        remove(list[i]);
    }
    group.freeAll();
    return true;
} catch (const std::bad_alloc &) {
    return false;
}
