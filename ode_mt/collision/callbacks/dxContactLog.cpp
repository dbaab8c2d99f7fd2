#include "collision/callbacks/dxContactLog.h"

#include <cstddef>
#include <new>
#include <utility>

#include "settings/dxJointAttachment.h"
#include "core/dxPrefetch.h"
#include "core/dxReserve.h"
#include "joints/contact.h"
#include "threading/pool/dxSpin.h"

// Upstream's: puts an object in front of a list of its world.
void addObjectToList(dObject *object, dObject **first);

namespace {

// Of a contact joint, for dxJointGroup::alloc, which constructs what it is asked for and marks it as in a
// group.
struct JointMemory {
    explicit JointMemory(dxWorld * /*world*/) {}
    alignas(dxJointContact) unsigned flags = 0;
    std::byte rest[sizeof(dxJointContact) - sizeof(unsigned)];
};
static_assert(sizeof(JointMemory) == sizeof(dxJointContact) && alignof(JointMemory) == alignof(dxJointContact));

// Of a mutex that is held for some ten nanoseconds at a time: sleeping takes a thousand times as long.
std::unique_lock<std::mutex> lockBriefly(std::mutex &mutex) {
    std::unique_lock<std::mutex> lock(mutex, std::defer_lock);
    if (!dxSpinUntil([&] { return lock.try_lock(); })) lock.lock();
    return lock;
}

__attribute__((tls_model("initial-exec"))) thread_local dxContactLog *t_current = nullptr;

}  // namespace

dxContactLog *dxContactLog::current() { return t_current; }

dxContactLog::Scope::Scope(dxContactLog &log, unsigned worker) : m_outer(std::exchange(t_current, &log)) { log.m_worker = worker; }
dxContactLog::Scope::~Scope() { t_current = m_outer; }

void dxContactLog::start(std::mutex &groups) {
    m_groups = &groups;
    m_operations.clear();
}

dJointID dxContactLog::create(dWorldID world, dJointGroupID group, const dContact *contact) {
    if (world == nullptr || contact == nullptr) return dxUpstreamJointCreateContact(world, group, contact);
    dxReserveCapacity(m_operations, m_operations.size() + 2);  // and that it is attached
    dxJointContact *const joint = construct(group);
    joint->contact = *contact;
    joint->world = world;
    m_operations.push_back({joint, nullptr, nullptr, true});
    return joint;
}

// Without the lock. Of no world.
dxJointContact *dxContactLog::construct(dxJointGroup *group) {
    dxJointContact *joint;
    if (group == nullptr) {
        joint = new dxJointContact(&m_constructionWorld);
    } else {
        joint = new (takeJointMemory(*group)) dxJointContact(&m_constructionWorld);
        joint->flags |= dJOINT_INGROUP;
    }
    m_constructionWorld.firstjoint = nullptr;
    m_constructionWorld.nj = 0;
    joint->world = nullptr;
    return joint;
}

// Several are allocated at once, to avoid coherence misses between tasks.
void *dxContactLog::takeJointMemory(dxJointGroup &group) {
    constexpr int kJointsPerAllocation = 8;
    if (m_freeJointsOf != &group) finish();
    if (m_freeJoints.empty()) {
        m_freeJoints.reserve(kJointsPerAllocation);
        const auto lock = lockBriefly(*m_groups);
        m_freeJointsOf = &group;
        for (int i = 0; i < kJointsPerAllocation; ++i) m_freeJoints.push_back(group.alloc<JointMemory>(nullptr));
    }
    void *const memory = m_freeJoints.back();
    m_freeJoints.pop_back();
    return memory;
}

// A group counts what it has given, and goes through its joints when it is emptied: joints of no world.
void dxContactLog::finish() {
    while (!m_freeJoints.empty()) construct(m_freeJointsOf);
    m_freeJointsOf = nullptr;
}

// What can be read from the joint is as after upstream's dJointAttach.
void dxContactLog::attach(dJointID joint, dBodyID body1, dBodyID body2) {
    m_operations.push_back({joint, body1, body2, false});
    if (joint == nullptr) return;  // upstream's message comes at the commit
    const bool isReversed = body1 == nullptr;
    joint->flags = isReversed ? joint->flags | dJOINT_REVERSE : joint->flags & ~dJOINT_REVERSE;
    joint->node[0].body = isReversed ? body2 : body1;
    joint->node[1].body = isReversed ? nullptr : body2;
}

// Joints were written by the task's worker, and bodies by whoever moved them last.
void dxContactLog::prefetch(std::size_t index) const {
    constexpr std::size_t kJointPrefetchDistance = 16, kBodyPrefetchDistance = 10;  // operations
    if (index + kJointPrefetchDistance < m_operations.size()) {
        const Operation &operation = m_operations[index + kJointPrefetchDistance];
        const auto begin = reinterpret_cast<const char *>(operation.joint);
        if (operation.isCreation)
            dxPrefetch::linesForWrite(begin, static_cast<std::size_t>(reinterpret_cast<const char *>(operation.joint->node + 2) - begin));
    }
    if (index + kBodyPrefetchDistance >= m_operations.size()) return;
    const Operation &operation = m_operations[index + kBodyPrefetchDistance];
    if (operation.body1 != nullptr) dxPrefetch::lineForWrite(&operation.body1->firstjoint);
    if (operation.body2 != nullptr) dxPrefetch::lineForWrite(&operation.body2->firstjoint);
}

void dxContactLog::commit(Span span) {
    for (std::uint32_t i = span.begin; i != span.end; ++i) {
        prefetch(i);
        const Operation &operation = m_operations[i];
        dxJoint *const joint = operation.joint;
        if (operation.isCreation) {
            addObjectToList(joint, reinterpret_cast<dObject **>(&joint->world->firstjoint));
            ++joint->world->nj;
            joint->node[0].body = joint->node[1].body = nullptr;
        } else {
            dxJointAttachment::attach(joint, operation.body1, operation.body2);
        }
    }
}
