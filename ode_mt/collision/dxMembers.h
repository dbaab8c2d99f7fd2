// The geoms of a space by slots, with what has changed since pairs were last looked for.
//
// A member's rank tells where it stands in upstream's list: of two members, the one with the higher rank
// stands further to the front.
//
// The slot of a member that goes is free at once, so there are never more slots, nor more changes, than there
// were members at one time, in a space that never looks for pairs too. Until the changes are forgotten such a
// slot counts as changed, whoever is in it: kept pairs with it are void, and searches take its box for one
// that moved. Not thread safe for changes; members may be read from several threads.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/common.h>

#include "collision/dxBounds.h"
#include "collision/dxMeetingFilter.h"
#include "collision/dxPairKey.h"
#include "simd/dxFetch.h"

class dxMembers {
public:
    using Slot = std::uint32_t;

    struct Member {
        dxGeom *geom = nullptr;  // NULL: the slot is free
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
    Slot end() const { return static_cast<Slot>(m_members.size()); }  // slots are below

    // Ranks are given downwards from a number that is above all earlier ones.
    dxRank firstOf(int ranks) { return m_highest += static_cast<dxRank>(ranks); }
    void setRank(Slot slot, dxRank rank) {
        Member &member = m_members[slot];
        if (member.rank == rank) return;
        if (member.rank == 0) --m_unranked;
        member.rank = rank;
        ++m_orderings;
    }
    int unranked() const { return m_unranked; }
    // Tells whoever is in a slot from those that were in it before.
    std::uint64_t arrivalOf(Slot slot) const { return m_arrivals[slot]; }
    // Rises whenever a member comes, goes or gets another rank.
    std::uint64_t orderings() const { return m_orderings; }

    void markChanged(Slot slot) {
        if (m_isChanged[slot]) return;
        m_isChanged[slot] = 1;
        m_changed.push_back(slot);
    }
    // Also slots of members that have gone, which may be free.
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
    void makeRoomForOne();

    std::vector<Member> m_members;
    std::vector<std::uint64_t> m_arrivals;  // by slot: how many had come by then
    std::uint64_t m_lastArrival = 0;
    std::vector<Slot> m_free;
    std::vector<Slot> m_changed;
    std::vector<std::uint8_t> m_isChanged;
    dxRank m_highest = 0;
    std::uint64_t m_orderings = 0;
    int m_unranked = 0;
};
