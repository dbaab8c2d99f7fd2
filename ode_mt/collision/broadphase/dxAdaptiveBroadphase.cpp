#include "collision/broadphase/dxAdaptiveBroadphase.h"

dxBroadPhase dxAdaptiveBroadphase::current() const {
    if (m_bruteForce != nullptr) return dxBroadPhase::SlotTable;
    if (m_verlet != nullptr) return dxBroadPhase::NeighbourList;
    return m_neighbours != nullptr ? dxBroadPhase::NeighbourSets : dxBroadPhase::None;
}

dxBroadPhaseFacts dxAdaptiveBroadphase::factsOf(const dxMembers &members) const {
    dxBroadPhaseFacts facts;
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

// A new Verlet list takes all members, changed or not; the other algorithms adopt those that have not changed.
void dxAdaptiveBroadphase::chooseBySize(const dxMembers &members) {
    const dxBroadPhase choice = dxChooseBroadPhase(factsOf(members));
    if (choice == current()) return;
    m_bruteForce.reset();
    m_verlet.reset();
    m_neighbours.reset();
    m_callsAgainst = 0;
    if (choice == dxBroadPhase::SlotTable) {
        m_bruteForce = std::make_unique<dxBruteForceBroadphase>();
        m_bruteForce->adopt(members);
    } else {
        m_verlet = std::make_unique<dxVerletBroadphase>(m_maxPairs);
    }
}

void dxAdaptiveBroadphase::findWithVerletList(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    dxBroadPhaseFacts facts = factsOf(members);
    facts.callsAgainst = m_callsAgainst = dxSpeaksAgainst(facts) ? m_callsAgainst + 1 : 0;
    if (dxChooseBroadPhase(facts) == dxBroadPhase::NeighbourList) {
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
    dxBroadPhaseFacts facts = factsOf(members);
    facts.lookedUp = m_neighbours->lookedUp();
    facts.callsAgainst = m_callsAgainst = dxSpeaksAgainst(facts) ? m_callsAgainst + 1 : 0;
    if (dxChooseBroadPhase(facts) == dxBroadPhase::NeighbourSets) return;
    m_neighbours.reset();
    m_verlet = std::make_unique<dxVerletBroadphase>(m_maxPairs);
    m_callsAgainst = 0;
}
