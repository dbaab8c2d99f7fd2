#include "collision/dxContactLog.h"

#include <utility>

#include "joints/joint.h"

// Upstream's: puts an object in front of a list of its world.
void addObjectToList(dObject *object, dObject **first);

extern "C" {
// Upstream's own, renamed by the seam ode/seams/ode.h.
dJointID dxUpstreamJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact);
void dxUpstreamJointAttach(dJointID joint, dBodyID body1, dBodyID body2);
}

namespace {

__attribute__((tls_model("initial-exec"))) thread_local dxContactLog *t_current = nullptr;

}  // namespace

dxContactLog *dxContactLog::current() { return t_current; }

dxContactLog::Scope::Scope(dxContactLog &log) : m_outer(std::exchange(t_current, &log)) {}
dxContactLog::Scope::~Scope() { t_current = m_outer; }

void dxContactLog::start(std::mutex &groups) {
    m_groups = &groups;
    m_operations.clear();
}

dJointID dxContactLog::create(dWorldID world, dJointGroupID group, const dContact *contact) {
    if (world == nullptr || contact == nullptr) return dxUpstreamJointCreateContact(world, group, contact);
    dJointID joint;
    {
        const std::lock_guard<std::mutex> lock(*m_groups);
        joint = dxUpstreamJointCreateContact(&m_nursery, group, contact);
    }
    if (joint == nullptr) return nullptr;
    m_nursery.firstjoint = nullptr;
    m_nursery.nj = 0;
    joint->world = world;
    m_operations.push_back({joint, nullptr, nullptr, true});
    return joint;
}

// What can be read from the joint is as after upstream's dJointAttach.
void dxContactLog::attach(dJointID joint, dBodyID body1, dBodyID body2) {
    m_operations.push_back({joint, body1, body2, false});
    if (joint == nullptr) return;  // upstream's message comes at the commit
    joint->flags &= ~dJOINT_REVERSE;
    if (body1 == nullptr) {
        std::swap(body1, body2);
        joint->flags |= dJOINT_REVERSE;
    }
    joint->node[0].body = body1;
    joint->node[1].body = body2;
}

void dxContactLog::commit(Span span) {
    for (std::uint32_t i = span.begin; i != span.end; ++i) {
        const Operation &operation = m_operations[i];
        dxJoint *const joint = operation.joint;
        if (operation.isCreation) {
            addObjectToList(joint, reinterpret_cast<dObject **>(&joint->world->firstjoint));
            ++joint->world->nj;
            joint->node[0].body = joint->node[1].body = nullptr;
        } else {
            dxUpstreamJointAttach(joint, operation.body1, operation.body2);
        }
    }
}
