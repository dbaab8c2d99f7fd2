#include "collision/broadphase/dxAdaptiveSearch.h"

dxBroadPhase dxAdaptiveSearch::current() const {
    if (m_table != nullptr) return dxBroadPhase::SlotTable;
    if (m_verlet != nullptr) return dxBroadPhase::NeighbourList;
    return m_neighbours != nullptr ? dxBroadPhase::NeighbourSets : dxBroadPhase::None;
}

dxBroadPhaseFacts dxAdaptiveSearch::factsOf(const dxMembers &members) const {
    dxBroadPhaseFacts facts;
    facts.current = current();
    facts.slots = members.end();
    facts.changed = members.changed().size();
    return facts;
}

void dxAdaptiveSearch::search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    chooseBySize(members);
    if (m_table != nullptr)
        m_table->search(members, runner, matches);
    else if (m_verlet != nullptr)
        searchVerlet(members, runner, matches);
    else
        searchNeighbours(members, runner, matches);
}

// A new Verlet list takes all members, changed or not; the other algorithms adopt those that have not changed.
void dxAdaptiveSearch::chooseBySize(const dxMembers &members) {
    const dxBroadPhase choice = dxChooseBroadPhase(factsOf(members));
    if (choice == current()) return;
    m_table.reset();
    m_verlet.reset();
    m_neighbours.reset();
    m_callsAgainst = 0;
    if (choice == dxBroadPhase::SlotTable) {
        m_table = std::make_unique<dxTableSearch>();
        m_table->adopt(members);
    } else {
        m_verlet = std::make_unique<dxVerletSearch>(m_maxPairs);
    }
}

void dxAdaptiveSearch::searchVerlet(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    dxBroadPhaseFacts facts = factsOf(members);
    facts.callsAgainst = m_callsAgainst = dxSpeaksAgainst(facts) ? m_callsAgainst + 1 : 0;
    if (dxChooseBroadPhase(facts) == dxBroadPhase::NeighbourList) {
        m_verlet->search(members, runner, matches);
        return;
    }
    m_verlet.reset();
    m_neighbours = std::make_unique<dxNeighbourSearch>();
    m_neighbours->adopt(members);
    m_neighbours->search(members, runner, matches);
}

void dxAdaptiveSearch::searchNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    m_neighbours->search(members, runner, matches);
    dxBroadPhaseFacts facts = factsOf(members);
    facts.lookedUp = m_neighbours->lookedUp();
    facts.callsAgainst = m_callsAgainst = dxSpeaksAgainst(facts) ? m_callsAgainst + 1 : 0;
    if (dxChooseBroadPhase(facts) == dxBroadPhase::NeighbourSets) return;
    m_neighbours.reset();
    m_verlet = std::make_unique<dxVerletSearch>(m_maxPairs);
    m_callsAgainst = 0;
}
