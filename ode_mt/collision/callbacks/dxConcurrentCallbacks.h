// dSpaceCollide with the near-callbacks of independent pairs on several threads, for programs that have declared that
// theirs may run so (dODE_MT_SetCallbackPolicy).
//
// Pairs are found as in serial calls. Workers run tasks that share no body (dxPairTasks), each task's pairs in order. Contact joints are logged by
// task (dxContactLog) and put into their lists after the last callback, pair by pair in upstream's order: that order decides the order of joints in
// islands, and with it that of rows, and the bits. So the world is the one that upstream leaves, as long as callbacks do what docs/callbacks.md
// requires of them.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include <ode/ode.h>

#include "collision/narrowphase/dxConcurrentColliders.h"
#include "config.h"
#include "objects.h"

class dxOrderedSpace;
class dxTaskRunner;
struct dxJointContact;

// Requires a space that is not locked and has at least two geoms. Returns false, before any callback, if it is not possible.
bool dxCollideConcurrently(dxOrderedSpace &space, dxTaskRunner &runner, void *data, dNearCallback *callback);

// The contact joints that a task's callbacks create. They are constructed immediately and inserted into the lists of
// world and bodies later.
//
// While a task runs callbacks its log is the current one of its thread: dJointCreateContact and dJointAttach (api/objects.cpp) write into it, and
// dODE_MT_GetWorkerIndex reads its worker. Until a joint is committed it refers to its bodies, but is in no list of the world or the bodies.
class dxContactLog {
public:
    // The range of one pair's operations in a log.
    struct Span {
        std::uint32_t begin = 0, end = 0;
    };

    // Returns the log of this thread, or NULL.
    static dxContactLog *current();

    // Makes a log current during its lifetime.
    class Scope {
    public:
        Scope(dxContactLog &log, unsigned worker);
        ~Scope();
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        dxContactLog *const m_outer;
    };

    // `groups` is locked while memory is allocated from a joint group, which tasks may share.
    void start(std::mutex &groups);

    std::uint32_t position() const { return static_cast<std::uint32_t>(m_operations.size()); }

    dJointID create(dWorldID world, dJointGroupID group, const dContact *contact);
    void attach(dJointID joint, dBodyID body1, dBodyID body2);

    // Returns the number of the worker that runs the task.
    unsigned worker() const { return m_worker; }

    // Returns the copies with which dCollide in this task's callbacks avoids writes to geoms that other tasks read.
    dxColliderCopies &copies() { return m_copies; }

    // Inserts the joints of a pair. Requires the thread that called dSpaceCollide.
    void commit(Span span);
    // Returns unused memory to the joint groups. Requires the same thread, after the last commit.
    void finish();

private:
    struct Operation {
        dJointID joint;
        dBodyID body1, body2;
        bool isCreation;
    };

    dxJointContact *construct(dxJointGroup *group);
    void *takeJointMemory(dxJointGroup &group);
    void prefetch(std::size_t index) const;

    unsigned m_worker = 0;
    std::vector<Operation> m_operations;
    dxColliderCopies m_copies;
    std::mutex *m_groups = nullptr;
    dxJointGroup *m_freeJointsOf = nullptr;
    std::vector<void *> m_freeJoints;  // memory for contact joints of that group
    dxWorld m_constructionWorld;  // joints are constructed in this world, because a joint's constructor writes to its world
};
