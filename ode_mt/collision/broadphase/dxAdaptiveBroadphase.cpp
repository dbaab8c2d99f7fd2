#include "collision/broadphase/dxAdaptiveBroadphase.h"

dxBroadphaseKind dxAdaptiveBroadphase::current() const {
    if (m_bruteForce != nullptr) return dxBroadphaseKind::BruteForce;
    if (m_verlet != nullptr) return dxBroadphaseKind::VerletList;
    return m_neighbours != nullptr ? dxBroadphaseKind::Neighbours : dxBroadphaseKind::None;
}

dxBroadphaseFacts dxAdaptiveBroadphase::factsOf(const dxMembers &members) const {
    dxBroadphaseFacts facts;
    facts.current = current();
    facts.slots = members.end();
    facts.changed = members.changed().size();
    return facts;
}

void dxAdaptiveBroadphase::findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    chooseBySize(members);
    if (m_bruteForce != nullptr)
        m_bruteForce->findOverlaps(members, runner, matches);
    else if (m_verlet != nullptr)
        findWithVerletList(members, runner, matches);
    else
        findWithNeighbours(members, runner, matches);
}

// A new Verlet list takes all members, changed or not; the other broad phases adopt those that have not changed.
void dxAdaptiveBroadphase::chooseBySize(const dxMembers &members) {
    const dxBroadphaseKind choice = dxChooseBroadphase(factsOf(members));
    if (choice == current()) return;
    m_bruteForce.reset();
    m_verlet.reset();
    m_neighbours.reset();
    m_mismatchStreak = 0;
    if (choice == dxBroadphaseKind::BruteForce) {
        m_bruteForce = std::make_unique<dxBruteForceBroadphase>();
        m_bruteForce->adopt(members);
    } else {
        m_verlet = std::make_unique<dxVerletBroadphase>(m_maxPairs);
    }
}

void dxAdaptiveBroadphase::findWithVerletList(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    dxBroadphaseFacts facts = factsOf(members);
    facts.mismatchStreak = m_mismatchStreak = dxPrefersOtherBroadphase(facts) ? m_mismatchStreak + 1 : 0;
    if (dxChooseBroadphase(facts) == dxBroadphaseKind::VerletList) {
        m_verlet->findOverlaps(members, runner, matches);
        return;
    }
    m_verlet.reset();
    m_neighbours = std::make_unique<dxNeighbourBroadphase>();
    m_neighbours->adopt(members);
    m_neighbours->findOverlaps(members, runner, matches);
}

void dxAdaptiveBroadphase::findWithNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    m_neighbours->findOverlaps(members, runner, matches);
    dxBroadphaseFacts facts = factsOf(members);
    facts.lookedUp = m_neighbours->lookedUp();
    facts.mismatchStreak = m_mismatchStreak = dxPrefersOtherBroadphase(facts) ? m_mismatchStreak + 1 : 0;
    if (dxChooseBroadphase(facts) == dxBroadphaseKind::Neighbours) return;
    m_neighbours.reset();
    m_verlet = std::make_unique<dxVerletBroadphase>(m_maxPairs);
    m_mismatchStreak = 0;
}
