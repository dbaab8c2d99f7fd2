#include "collision/dxContactLog.h"

#include <cstddef>
#include <new>
#include <utility>

#include "joints/contact.h"
#include "threading/dxSpin.h"

// Upstream's: puts an object in front of a list of its world.
void addObjectToList(dObject *object, dObject **first);

extern "C" {
// Upstream's own, renamed by the seam ode/seams/ode.h.
dJointID dxUpstreamJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact);
void dxUpstreamJointAttach(dJointID joint, dBodyID body1, dBodyID body2);
}

namespace {

// Of a contact joint, for dxJointGroup::alloc, which constructs what it is asked for and marks it as in a group.
struct Room {
    explicit Room(dxWorld * /*world*/) {}
    alignas(dxJointContact) unsigned flags = 0;
    std::byte rest[sizeof(dxJointContact) - sizeof(unsigned)];
};
static_assert(sizeof(Room) == sizeof(dxJointContact) && alignof(Room) == alignof(dxJointContact));

// A mutex that is held for some ten nanoseconds at a time: sleeping takes a thousand times as long.
class BriefLock {
public:
    explicit BriefLock(std::mutex &mutex) : m_mutex(mutex) {
        constexpr int kTries = 200;
        for (int i = 0; i < kTries; ++i) {
            if (m_mutex.try_lock()) return;
            dxPause();
        }
        m_mutex.lock();
    }
    ~BriefLock() { m_mutex.unlock(); }
    BriefLock(const BriefLock &) = delete;
    BriefLock &operator=(const BriefLock &) = delete;

private:
    std::mutex &m_mutex;
};

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
    const dJointID joint = group == nullptr ? dxUpstreamJointCreateContact(&m_nursery, nullptr, contact)
                                            : createInGroup(*group, *contact);
    m_nursery.firstjoint = nullptr;
    m_nursery.nj = 0;
    joint->world = world;
    m_operations.push_back({joint, nullptr, nullptr, true});
    return joint;
}

// As upstream's dJointCreateContact, but constructed without the lock.
dJointID dxContactLog::createInGroup(dxJointGroup &group, const dContact &contact) {
    void *const room = takeRoom(group);
    auto *const joint = new (room) dxJointContact(&m_nursery);
    joint->flags |= dJOINT_INGROUP;
    joint->contact = contact;
    return joint;
}

void *dxContactLog::takeRoom(dxJointGroup &group) const {
    const BriefLock lock(*m_groups);
    return group.alloc<Room>(nullptr);
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
