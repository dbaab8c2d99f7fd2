// Contact joints that callbacks make on several threads at once: made at once, put into the lists of world
// and bodies later, pair by pair, in the order in which upstream would have made them.
//
// That order decides the order of joints in islands, and with it of rows and bits. Until a joint is committed
// it knows its bodies, but the world and the bodies do not know it.
//
// One log for each task. While a task runs callbacks its log is the current one of its thread, and
// dJointCreateContact and dJointAttach (ode_mt/api/objects.cpp) write into it.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include <ode/ode.h>

#include "collision/narrowphase/dxSharedColliders.h"
#include "config.h"
#include "objects.h"

struct dxJointContact;

class dxContactLog {
public:
    // Where one pair's operations stand in a log.
    struct Span {
        std::uint32_t begin = 0, end = 0;
    };

    // That of this thread, or NULL.
    static dxContactLog *current();

    // Makes a log current for as long as it lives.
    class Scope {
    public:
        explicit Scope(dxContactLog &log);
        ~Scope();
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        dxContactLog *const m_outer;
    };

    // `groups`: held while memory is taken from a joint group, which tasks may share.
    void start(std::mutex &groups);

    std::uint32_t position() const { return static_cast<std::uint32_t>(m_operations.size()); }

    dJointID create(dWorldID world, dJointGroupID group, const dContact *contact);
    void attach(dJointID joint, dBodyID body1, dBodyID body2);

    // For dCollide in this task's callbacks: what other tasks collide, too, is not written to.
    dxColliderCopies &copies() { return m_copies; }

    // On the thread that called dSpaceCollide.
    void commit(Span span);
    // Likewise, after the last commit: what was taken of joint groups and not used.
    void finish();

private:
    struct Operation {
        dJointID joint;
        dBodyID body1, body2;
        bool isCreation;
    };

    dxJointContact *construct(dxJointGroup *group);
    void *takeRoom(dxJointGroup &group);

    std::vector<Operation> m_operations;
    dxColliderCopies m_copies;
    std::mutex *m_groups = nullptr;
    dxJointGroup *m_roomsOf = nullptr;
    std::vector<void *> m_rooms;  // for contact joints of that group
    dxWorld m_nursery;  // where joints are made: a joint's constructor writes to its world
};
