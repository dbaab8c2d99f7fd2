#include "dynamics/step/islands/dxStepTimeline.h"

#include <utility>

#include "settings/dxWorldState.h"

namespace {

constexpr dxTimelineEvent kStep{"step", "step", {"bodies", "islands", "rows", "threads"}};
constexpr dxTimelineEvent kCounters{"of a step", "counter", {"islands", "contacts", "rows", "threads"}, dxTimelineEvent::Kind::Counter};

unsigned countContacts(const dxWorld &world) {
    unsigned contacts = 0;
    for (const dxJoint *joint = world.firstjoint; joint != nullptr; joint = static_cast<const dxJoint *>(joint->next))
        contacts += joint->type() == dJointTypeContact;
    return contacts;
}

}  // namespace

void dxStepSpan::beginSearch() {
    dxTimeline::honourRequest();
    dxTimelineRing *const ring = dxTimeline::ofThisThread();
    if (ring == nullptr) return;
    ring->outerTimes = ring->times();
    ring->stepBegin = ring->readClock();
    ring->setTimes({});
    ring->collisionDepth = 0;
}

void dxStepSpan::begin(const dxWorld *world, unsigned islands) {
    m_islands = islands;
    m_bodies = static_cast<unsigned>(world->nb);
    m_contacts = countContacts(*world);
    m_begin = std::exchange(m_ring->stepBegin, 0);
    m_outer = {m_ring->outerTimes, m_ring->takeRowsOfStep(), m_ring->caller(), m_ring->takeThreads()};
    m_ring->becomeCaller();
}

// It ends with the last of its events.
void dxStepSpan::end() {
    const std::uint64_t now = m_ring->lastReading(), rows = m_ring->takeRowsOfStep();
    const unsigned threads = m_ring->takeThreads();
    m_ring->add(kCounters, now, now, {m_islands, m_contacts, rows, threads});
    if (m_begin != 0) m_ring->add(kStep, m_begin, now, {m_bodies, m_islands, rows, threads});
    m_ring->nextFrame();
    if (dxTimeline::isCounted() && m_begin != 0)
        dxWorldStatistics::add(m_world, {m_begin, now, m_ring->times(), rows, threads, dxWorldSettings::of(m_world).threadsInForce(),
                                         m_bodies, m_contacts, m_islands, m_reason, m_remote});
    goOnWithOuter();
}

// There may be none: what is given back is what the next one begins with, and takes no notice of.
void dxStepSpan::goOnWithOuter() {
    m_ring->setTimes(m_outer.times);
    m_ring->giveRowsBack(m_outer.rows);
    m_ring->noteThreads(m_outer.threads);
    if (m_outer.caller.ring != m_ring) m_ring->setCaller(m_outer.caller);
}
