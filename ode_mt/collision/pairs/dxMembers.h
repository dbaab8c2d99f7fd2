// The geoms of a space by slots, with what has changed since pairs were last looked for.
//
// A member's rank tells where it stands in upstream's list: of two members, the one with the higher rank
// stands further to the front.
//
// The slot of a member that goes is free at once, so there are never more slots, nor more changes, than there
// were members at one time, in a space that never looks for pairs too. Until the changes are forgotten such a
// slot counts as changed, whoever is in it: kept pairs with it are void, and searches take its box for one
// that moved. Not thread safe for changes; members may be read from several threads.
//
// A member whose geom is disabled is absent: no search finds it, so that pools of disabled geoms that lie in one place cost
// nothing. It keeps its rank and its bounds for when it is enabled again.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/pairs/dxMeetingFilter.h"
#include "collision/pairs/dxPairKey.h"
#include "core/dxBounds.h"
#include "core/dxFetch.h"

class dxMembers {
public:
    using Slot = std::uint32_t;

    struct Member {
        dxGeom *geom = nullptr;  // NULL: nobody who meets others, the slot is free or its member absent
        dxRank rank = 0;         // 0: none yet
        dxBounds bounds;         // as of the last cleaning
        dxMeetingFilter filter;
    };

    // Throws std::bad_alloc, with nothing changed; nothing else here asks for memory.
    Slot add(dxGeom *geom);
    void remove(Slot slot);

    // Asks the memory for a member that will be looked at soon.
    void expect(Slot slot) const {
        const char *const place = reinterpret_cast<const char *>(&m_members[slot]);
        dxFetch::line(place);
        dxFetch::line(place + sizeof(Member) - 1);
    }

    const Member &operator[](Slot slot) const { return m_members[slot]; }
    // Also an absent one. NULL: the slot is free.
    dxGeom *geomIn(Slot slot) const { return m_geoms[slot]; }
    bool isPresent(Slot slot) const { return m_members[slot].geom != nullptr; }
    void setPresence(Slot slot, bool isPresent);
    // It may have to become present or absent: not at once, since pairs may be in use.
    void noteSwitch(Slot slot);
    // Also slots that have become free.
    const std::vector<Slot> &switched() const { return m_switched; }
    void forgetSwitches();
    Slot end() const { return static_cast<Slot>(m_members.size()); }  // slots are below

    // Ranks are given downwards from a number that is above all earlier ones.
    dxRank firstOf(int ranks) { return m_highest += static_cast<dxRank>(ranks); }
    void setRank(Slot slot, dxRank rank) {
        Member &member = m_members[slot];
        if (member.rank == rank) return;
        if (member.rank == 0) --m_unranked;
        member.rank = rank;
        if (isPresent(slot)) ++m_orderings;
    }
    int unranked() const { return m_unranked; }
    // Tells whoever is in a slot from those that were in it before.
    std::uint64_t arrivalOf(Slot slot) const { return m_arrivals[slot]; }
    // Rises whenever a present member comes, goes or gets another rank.
    std::uint64_t orderings() const { return m_orderings; }

    // An absent one has no pairs.
    void markChanged(Slot slot) {
        if (isPresent(slot)) note(slot, m_isChanged, m_changed);
    }
    // Also slots of members that have gone or become absent.
    const std::vector<Slot> &changed() const { return m_changed; }
    bool isChanged(Slot slot) const { return m_isChanged[slot] != 0; }
    void setBounds(Slot slot, const dxBounds &bounds, const dxMeetingFilter &filter = {}) {
        Member &member = m_members[slot];
        member.bounds = bounds;
        member.filter = filter;
    }
    void setFilter(Slot slot, const dxMeetingFilter &filter) { m_members[slot].filter = filter; }
    void forgetChanges();

private:
    using Flags = std::vector<std::uint8_t>;

    void makeRoomForOne();
    // Lists it once.
    static void note(Slot slot, Flags &isNoted, std::vector<Slot> &noted) {
        if (isNoted[slot] != 0) return;
        isNoted[slot] = 1;
        noted.push_back(slot);
    }
    static void forget(Flags &isNoted, std::vector<Slot> &noted) {
        for (const Slot slot : noted) isNoted[slot] = 0;
        noted.clear();
    }

    std::vector<Member> m_members;
    std::vector<dxGeom *> m_geoms;          // by slot
    std::vector<std::uint64_t> m_arrivals;  // by slot: how many had come by then
    std::uint64_t m_lastArrival = 0;
    std::vector<Slot> m_free;
    std::vector<Slot> m_changed, m_switched;
    Flags m_isChanged, m_isSwitched;  // by slot
    dxRank m_highest = 0;
    std::uint64_t m_orderings = 0;
    int m_unranked = 0;
};
