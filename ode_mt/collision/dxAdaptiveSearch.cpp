#include "collision/dxAdaptiveSearch.h"

namespace {

// Slots of members up to which comparing boxes by vectors is faster, whatever share of them moves. A space on the border
// does not go back and forth: it has a table again at half of it.
constexpr std::size_t kLargestTable = 128;

// Looking a box up costs about as much as making a list does for ten boxes.
constexpr std::size_t kListedPerLookUp = 10;

// Comparing the neighbours of a box that moves costs about as much as comparing the candidates of five.
constexpr std::size_t kListedPerMove = 5;

// Below, neither takes long.
constexpr std::size_t kLeastLookUps = 32;

// So many calls in a row with few changes must come before neighbours are built up again, which costs a look-up
// for each member; and so many with many changes before a list is made instead.
constexpr int kCallsToTell = 8;

}  // namespace

void dxAdaptiveSearch::search(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    chooseTable(members);
    if (m_table != nullptr)
        m_table->search(members, runner, matches);
    else if (m_verlet != nullptr)
        searchVerlet(members, runner, matches);
    else
        searchNeighbours(members, runner, matches);
}

// A new list takes in all members, whether or not they have changed; the others are told of those that have not.
void dxAdaptiveSearch::chooseTable(const dxMembers &members) {
    const bool isFirst = m_table == nullptr && m_verlet == nullptr && m_neighbours == nullptr;
    const std::size_t most = isFirst || m_table != nullptr ? kLargestTable : kLargestTable / 2;
    const bool shallBeTable = members.end() <= most;
    if (!isFirst && shallBeTable == isTable()) return;
    m_table.reset();
    m_verlet.reset();
    m_neighbours.reset();
    m_callsAgainst = 0;
    if (shallBeTable) {
        m_table = std::make_unique<dxTableSearch>();
        m_table->adopt(members);
    } else {
        m_verlet = std::make_unique<dxVerletSearch>(m_mostPairs);
    }
}

void dxAdaptiveSearch::searchVerlet(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) {
    const bool isQuiet = members.changed().size() * kListedPerLookUp < members.end();
    m_callsAgainst = isQuiet ? m_callsAgainst + 1 : 0;
    if (m_callsAgainst < kCallsToTell) {
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
    const bool isBusy = members.changed().size() * kListedPerMove >= members.end();
    m_callsAgainst = isBusy ? m_callsAgainst + 1 : 0;
    const std::size_t lookUps = m_neighbours->lookedUp();
    const bool manyLeft = lookUps >= kLeastLookUps && lookUps * kListedPerLookUp >= members.end();
    if (!manyLeft && m_callsAgainst < kCallsToTell) return;
    m_neighbours.reset();
    m_verlet = std::make_unique<dxVerletSearch>(m_mostPairs);
    m_callsAgainst = 0;
}
