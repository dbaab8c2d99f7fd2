#include "dynamics/dxJointRemoval.h"

#include <new>
#include <vector>

#include "core/dxFetch.h"
#include "threading/process/dxIdlePool.h"
#include "threading/process/dxProcessObject.h"

#include "config.h"
#include "joints/joint.h"
#include "objects.h"

namespace {

// Joints between asking the memory for one, or for the bodies that it names, and removing it.
constexpr std::size_t kAhead = 8, kBodiesAhead = 4;

dxProcessObject<dxIdlePool<std::vector<dxJoint *>>> lists;

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

void fetch(const dxJoint *joint) {
    dxFetch::lineToWrite(&joint->world);
    dxFetch::lineToWrite(&joint->node[1]);
}

void fetchBodies(const dxJoint *joint) {
    for (const dxJointNode &node : joint->node)
        if (node.body != nullptr) dxFetch::lineToWrite(&node.body->firstjoint);
}

void remove(dxJoint *joint) {
    if (joint->world != nullptr) removeFromWorld(joint);  // else its world has gone before it
    joint->~dxJoint();
}

}  // namespace

bool dxRemoveJoints(dxJointGroup &group) try {
    const std::size_t count = group.getJointCount();
    if (count == 0) return true;
    const dxIdleLease<std::vector<dxJoint *>> lease(*lists);
    std::vector<dxJoint *> &list = *lease;
    list.resize(count);
    group.exportJoints(list.data());
    for (std::size_t i = count; i-- != 0;) {
        if (i >= kAhead) fetch(list[i - kAhead]);
        if (i >= kBodiesAhead) fetchBodies(list[i - kBodiesAhead]);
        remove(list[i]);
    }
    group.freeAll();
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

void dxForgetJointRemoval() {
    lists->clear([](std::vector<dxJoint *> *list) { delete list; });
}
