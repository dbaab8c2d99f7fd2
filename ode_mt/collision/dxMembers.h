// The geoms of a space by slots, with what has changed since pairs were last looked for.
//
// A member's rank tells where it stands in upstream's list: of two members, the one with the higher rank
// stands further to the front. Slots of members that go are not given again before the changes are
// forgotten, so that a slot in a kept pair always means the geom that it meant then.
// Not thread safe.
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
        dxGeom *geom = nullptr;  // NULL: nobody
        dxRank rank = 0;         // 0: none yet
        dxBounds bounds;         // as of the last cleaning
        dxMeetingFilter filter;
        bool sought = false;     // has bounds: pairs may have been looked for since it came
    };

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
    // Rises whenever a member comes, goes or gets another rank.
    std::uint64_t orderings() const { return m_orderings; }

    void markChanged(Slot slot) {
        if (m_isChanged[slot]) return;
        m_isChanged[slot] = 1;
        m_changed.push_back(slot);
    }
    // Also of members that have gone; those are nobody.
    const std::vector<Slot> &changed() const { return m_changed; }
    bool isChanged(Slot slot) const { return m_isChanged[slot] != 0; }
    void setBounds(Slot slot, const dxBounds &bounds, const dxMeetingFilter &filter = {}) {
        Member &member = m_members[slot];
        member.bounds = bounds;
        member.filter = filter;
        member.sought = true;
    }
    void setFilter(Slot slot, const dxMeetingFilter &filter) { m_members[slot].filter = filter; }
    void forgetChanges();

private:
    std::vector<Member> m_members;
    std::vector<Slot> m_free, m_gone;  // m_gone: free when the changes are forgotten
    std::vector<Slot> m_changed;
    std::vector<std::uint8_t> m_isChanged;
    dxRank m_highest = 0;
    std::uint64_t m_orderings = 0;
    int m_unranked = 0;
};
