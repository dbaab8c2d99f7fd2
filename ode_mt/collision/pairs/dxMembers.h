// The geoms of a space by slots, with the changes since the pairs were last updated.
//
// A member's rank gives its place in upstream's list: of two members, the one with the higher rank is further to the front.
//
// The slot of a removed member is free at once. So there are never more slots, nor more changes, than there were members at one time, even in a space
// that never updates its pairs. Until the changes are forgotten such a slot counts as changed, whatever member is in it: kept pairs with it are
// invalid, and the broad phase treats its box as one that moved.
//
// A member whose geom is disabled is absent: the broad phase does not find it, so pools of disabled geoms in one place cost nothing. It keeps its
// rank and its bounds until it is enabled again. Threading: changes are not thread-safe; several threads may read.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/pairs/dxPair.h"
#include "core/dxBounds.h"
#include "core/dxPrefetch.h"

class dxMembers {
public:
    using Slot = std::uint32_t;

    struct Member {
        dxGeom *geom = nullptr;  // NULL: the slot is free or its member absent
        dxRank rank = 0;         // 0: none yet
        dxBounds bounds;         // as of the last cleaning
        dxPairFilter filter;
    };

    // Adds a member and returns its slot. Throws std::bad_alloc without any change. No other function allocates memory.
    Slot add(dxGeom *geom);
    void remove(Slot slot);

    // Prefetches a member.
    void prefetch(Slot slot) const {
        const char *const place = reinterpret_cast<const char *>(&m_members[slot]);
        dxPrefetch::line(place);
        dxPrefetch::line(place + sizeof(Member) - 1);
    }

    const Member &operator[](Slot slot) const { return m_members[slot]; }
    // Returns the member in slot 0. Valid until the next add().
    const Member *data() const { return m_members.data(); }
    // Returns the geom in a slot, present or absent; NULL: the slot is free.
    dxGeom *geomIn(Slot slot) const { return m_geoms[slot]; }
    bool isPresent(Slot slot) const { return m_members[slot].geom != nullptr; }
    void setPresence(Slot slot, bool isPresent);
    // Notes that the member may become present or absent. The change is deferred, since pairs may be in use.
    void noteSwitch(Slot slot);
    // Returns the noted slots, including slots that have become free.
    const std::vector<Slot> &switched() const { return m_switched; }
    void forgetSwitches();
    // Returns one past the last slot.
    Slot end() const { return static_cast<Slot>(m_members.size()); }

    // Returns the highest of a number of new ranks, which are above all earlier ones and are assigned downwards.
    dxRank firstOf(int ranks) { return m_highest += static_cast<dxRank>(ranks); }
    void setRank(Slot slot, dxRank rank) {
        Member &member = m_members[slot];
        if (member.rank == rank) return;
        if (member.rank == 0) --m_unranked;
        member.rank = rank;
        if (isPresent(slot)) ++m_orderings;
    }
    int unranked() const { return m_unranked; }
    // Returns a number that distinguishes the member in a slot from earlier members in it.
    std::uint64_t arrivalOf(Slot slot) const { return m_arrivals[slot]; }
    // Returns a counter of changes of the order: it rises when a present member is added or removed or gets another rank.
    std::uint64_t orderings() const { return m_orderings; }
    // Returns a counter of changes of members' boxes, and, for the last kPlacingsKnown of these, the member whose box it was.
    std::uint64_t placings() const { return m_placings; }
    static constexpr std::uint64_t kPlacingsKnown = 16;
    Slot placed(std::uint64_t placing) const { return m_placed[placing % kPlacingsKnown]; }

    // Marks a member as changed. An absent member has no pairs and is not marked.
    void markChanged(Slot slot) {
        if (isPresent(slot)) note(slot, m_isChanged, m_changed);
    }
    // Marks all slots as changed, even those of absent and removed members, for a keeper of pairs that has missed changes.
    void markAllChanged() {
        for (Slot slot = 0; slot < end(); ++slot) note(slot, m_isChanged, m_changed);
    }
    // Returns the changed slots, including those of members that were removed or became absent.
    const std::vector<Slot> &changed() const { return m_changed; }
    bool isChanged(Slot slot) const { return m_isChanged[slot] != 0; }
    bool areUnchanged(Slot a, Slot b) const { return !isChanged(a) && !isChanged(b); }
    void setBounds(Slot slot, const dxBounds &bounds, const dxPairFilter &filter = {}) {
        Member &member = m_members[slot];
        member.bounds = bounds;
        member.filter = filter;
        m_placed[m_placings++ % kPlacingsKnown] = slot;
    }
    // Sets rank, bounds and filter of a member. Returns false, and sets nothing, if more than these would change: the member is absent, has no rank
    // yet, or its geom is disabled. Several threads may call this for different members; moved() must follow, on one thread.
    bool place(Slot slot, dxRank rank, const dxBounds &bounds, const dxPairFilter &filter, bool isEnabled) {
        Member &member = m_members[slot];
        if (member.geom == nullptr || member.rank == 0 || !isEnabled) return false;
        member = {member.geom, rank, bounds, filter};
        return true;
    }
    // Requires that place() has returned true.
    void moved(Slot slot) {
        ++m_orderings;
        note(slot, m_isChanged, m_changed);
    }
    void setFilter(Slot slot, const dxPairFilter &filter) { m_members[slot].filter = filter; }
    void forgetChanges();

private:
    using Flags = std::vector<std::uint8_t>;

    void reserveForOneMore();
    // Adds a slot to a list once.
    static void note(Slot slot, Flags &isNoted, std::vector<Slot> &noted) {
        if (isNoted[slot] != 0) return;
        isNoted[slot] = 1;
        noted.push_back(slot);
    }
    static void forget(Flags &isNoted, std::vector<Slot> &noted) {
        for (const Slot slot : noted) isNoted[slot] = 0;
        noted.clear();
    }

    int m_unranked = 0;  // first, because every query reads it
    std::vector<Member> m_members;
    std::vector<dxGeom *> m_geoms;          // by slot
    std::vector<std::uint64_t> m_arrivals;  // by slot: m_lastArrival when the member was added
    std::uint64_t m_lastArrival = 0;  // number of members ever added
    std::vector<Slot> m_free;
    std::vector<Slot> m_changed, m_switched;
    Flags m_isChanged, m_isSwitched;  // by slot
    dxRank m_highest = 0;
    std::uint64_t m_orderings = 0, m_placings = 0;
    std::array<Slot, kPlacingsKnown> m_placed{};
};
