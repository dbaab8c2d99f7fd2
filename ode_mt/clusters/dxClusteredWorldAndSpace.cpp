#include "clusters/dxClusteredWorldAndSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {

using Kind = dxClusterScene::Kind;

// Minimum number of checks between two placements of the grid, whose cost is proportional to all inhabitants.
constexpr int kChecksBetweenFits = 16;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Number of cells on each axis before setCells(): thesis 10.2 begins with the minimum.
constexpr int kFirstCells = dxClusterGrid::kMinCells;

}  // namespace

dxClusteredWorldAndSpace::dxClusteredWorldAndSpace(std::unique_ptr<dxCrossoverPass> pass)
    : m_pass(std::move(pass)), m_wantedCells(kFirstCells) {
    m_scene.setGrid(dxClusterGrid());
}

void dxClusteredWorldAndSpace::findOverlaps(const dxMembers &members, dxTaskRunner &, std::vector<Match> &matches) {
    travel(members);
    check(members);
    findPairs(members, matches);
}

double dxClusteredWorldAndSpace::travel(const dxMembers &members) {
    m_history.rest();
    m_isNoted.resize(members.end());
    for (const Slot slot : members.changed()) {
        note(slot);
        m_travel = std::max(m_travel, travelOf(slot, members));
    }
    if (m_travel == kInfinite) return kInfinite;
    gatherLinks(members);
    return m_linksChanged ? kInfinite : std::nextafter(m_travel, kInfinite);  // differences are rounded to nearest
}

void dxClusteredWorldAndSpace::note(Slot slot) {
    if (m_isNoted[slot]) return;
    m_isNoted[slot] = 1;
    m_noted.push_back(slot);
}

bool dxClusteredWorldAndSpace::isAnother(Slot slot, const dxMembers &members) const {
    return slot >= m_arrivals.size() || m_arrivals[slot] != members.arrivalOf(slot);
}

double dxClusteredWorldAndSpace::travelOf(Slot slot, const dxMembers &members) const {
    const dxGeom *const geom = members[slot].geom;
    const bool known = slot < m_scene.end() && m_scene[slot].kind != Kind::none;
    if (geom == nullptr && !known) return 0;  // added and removed since
    if (geom == nullptr || !known || m_scene[slot].kind != dxKindOf(geom) || isAnother(slot, members)) return kInfinite;
    double furthest = 0;
    for (int bound = 0; bound < 6; ++bound) {
        const dReal from = m_scene[slot].bounds.v[bound], to = members[slot].bounds.v[bound];
        if (from == to) continue;
        const double moved = std::abs(static_cast<double>(to) - static_cast<double>(from));
        if (!(moved < kInfinite)) return kInfinite;  // also NaN
        furthest = std::max(furthest, moved);
    }
    return furthest;
}

void dxClusteredWorldAndSpace::gatherLinks(const dxMembers &members) {
    if (m_links.gather(members, m_scene)) m_linksChanged = true;
    m_linksKnown = true;
}

void dxClusteredWorldAndSpace::check(const dxMembers &members) {
    updateScene(members);
    updateGrid();
    if (!m_linksKnown || m_scene.changes() != m_changesSeen) gatherLinks(members);
    if (m_linksChanged || m_scene.changes() != m_changesSeen) cross();
    m_travel = 0;
    m_linksChanged = false;
}

void dxClusteredWorldAndSpace::findPairs(const dxMembers &members, std::vector<Match> &matches) {
    m_linksKnown = false;
    for (int cluster = 0; cluster < m_clusters.dynamicCount(); ++cluster)
        findPairsInCluster(cluster, members, matches);
    for (const Slot slot : members.changed())
        if (members[slot].geom != nullptr && !isClustered(slot)) findPairsWithAll(slot, members, matches);
}

void dxClusteredWorldAndSpace::updateScene(const dxMembers &members) {
    m_arrivals.resize(members.end());  // 0: no member's
    for (const Slot slot : m_noted) {
        m_isNoted[slot] = 0;
        const dxMembers::Member &member = members[slot];
        if (isAnother(slot, members)) {  // the previous member of the slot was removed
            m_scene.remove(slot);
            m_clusters.forgetMember(slot);
            m_arrivals[slot] = members.arrivalOf(slot);
        }
        if (member.geom != nullptr)
            m_scene.put(slot, dxKindOf(member.geom), member.bounds);
        else
            m_scene.remove(slot);
    }
    m_noted.clear();
}

void dxClusteredWorldAndSpace::updateGrid() {
    const bool first = m_checksSinceFit == 0;
    if (m_checksSinceFit <= kChecksBetweenFits) ++m_checksSinceFit;
    const bool due = m_checksSinceFit > kChecksBetweenFits && m_watchesGrid && dxGridIsOutgrown(m_scene);
    if (!first && !due && !wantsGrid()) return;
    m_checksSinceFit = 1;
    m_isMisplaced = false;
    m_scene.setGrid(dxFitGrid(m_scene, m_wantedCells));
    m_madeAnew = true;  // clusters are made as at the start, not kept merged
}

void dxClusteredWorldAndSpace::cross() {
    m_changesSeen = m_scene.changes();
    std::swap(m_clusters, m_before);
    m_clusters.clear(m_scene.end());
    const dxClusters nothing;
    m_pass->cross(m_scene, m_links.all(), m_madeAnew ? nothing : m_before, m_clusters);
    m_madeAnew = false;
    m_history.follow(m_before, m_clusters);
    gatherApart();
}

void dxClusteredWorldAndSpace::gatherApart() {
    m_apart.clear();
    for (const Slot slot : m_scene.big())
        if (m_scene[slot].kind == Kind::dynamicGeom || !m_pass->listsBigStatics()) m_apart.push_back(slot);
    if (!m_pass->setsStaticsApart()) return;
    const std::vector<Slot> &statics = m_scene.all(Kind::staticGeom);
    m_apart.insert(m_apart.end(), statics.begin(), statics.end());
}

bool dxClusteredWorldAndSpace::isClustered(Slot slot) const {
    return m_scene[slot].kind == Kind::dynamicGeom && !m_scene[slot].big;
}

// The changed members come first: each is compared with all behind it.
void dxClusteredWorldAndSpace::findPairsInCluster(int number, const dxMembers &members, std::vector<Match> &matches) {
    const dxClusters::Cluster &cluster = m_clusters[number];
    m_listed.clear();
    for (const Slot slot : cluster.members)
        if (members.isChanged(slot)) m_listed.push_back(slot);
    const std::size_t changed = m_listed.size();
    if (changed == 0) return;
    for (const Slot slot : cluster.members)
        if (!members.isChanged(slot)) m_listed.push_back(slot);
    m_listed.insert(m_listed.end(), m_apart.begin(), m_apart.end());
    m_listed.insert(m_listed.end(), cluster.duplicated.begin(), cluster.duplicated.end());
    for (const int other : cluster.staticClusters) {
        const std::vector<Slot> &statics = m_clusters[other].members;
        m_listed.insert(m_listed.end(), statics.begin(), statics.end());
    }
    m_boxes.clear();
    for (const Slot slot : m_listed) m_boxes.push(members[slot].bounds);
    const std::size_t count = dxOverlappingPairs(m_boxes, changed, m_together);
    for (std::size_t i = 0; i < count; ++i) matches.push_back({m_listed[m_together[i].a], m_listed[m_together[i].b]});
}

// A static or big member that changed is in no dynamic cluster, so it is compared with everything, except
// with changed members of clusters, which have found it.
void dxClusteredWorldAndSpace::findPairsWithAll(Slot slot, const dxMembers &members,
                                             std::vector<Match> &matches) const {
    for (Slot other = 0; other < members.end(); ++other) {
        if (members[other].geom == nullptr || other == slot) continue;
        if (members.isChanged(other) && (isClustered(other) || other < slot)) continue;
        if (members[slot].bounds.overlaps(members[other].bounds)) matches.push_back({slot, other});
    }
}

int dxClusteredWorldAndSpace::groupOf(Slot slot) const {
    const int cluster = m_clusters.of(slot);
    return cluster == dxClusters::kNone ? kNoGroup : m_clusters[cluster].task;
}

bool dxClusteredWorldAndSpace::isTestedWith(Slot slot, int number) const {
    const auto holds = [](const auto &list, auto value) {
        return std::find(list.begin(), list.end(), value) != list.end();
    };
    const dxClusters::Cluster &cluster = m_clusters[number];
    return m_clusters.of(slot) == number || holds(m_apart, slot) || holds(cluster.duplicated, slot) ||
           holds(cluster.staticClusters, m_clusters.of(slot));
}

int dxClusteredWorldAndSpace::entities() const {
    dxDisjointSets sets;
    sets.reset(m_scene.end());
    dxUniteByLinks(m_links.all(), sets);
    const std::vector<Slot> &dynamics = m_scene.all(Kind::dynamicGeom);
    return static_cast<int>(
        std::count_if(dynamics.begin(), dynamics.end(), [&](Slot slot) { return sets.find(slot) == slot; }));
}
