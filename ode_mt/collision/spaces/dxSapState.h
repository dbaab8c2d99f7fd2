// What the parts of a sweep-and-prune space share: the boxes of its members along its axes, and what a call leaves to later calls.
//
// The cleaner writes boxes, the pair order writes parts and positions, the walker the last sweep. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/spaces/dxSapBox.h"
#include "collision/spaces/dxSapSort.h"
#include "collision/spaces/dxSapWalk.h"
#include "collision/spaces/dxSpaceGeoms.h"

// Prefetch distance of the parts of a sweep-and-prune space, in members.
constexpr std::size_t kSapPrefetchDistance = 8;

enum class dxSapPart : std::uint8_t { absent, swept, infinite };

struct dxSapMember {
    dxSapBox box;            // as of the last cleaning
    std::uint32_t position;  // among those swept
    dxSapPart part;
};

class dxSapState {
public:
    explicit dxSapState(int axisOrder) : axes(axisOrder), m_sweep(axes) {}

    const dxSapAxes axes;
    std::vector<dxSapMember> members;  // by slot
    dxSapSort sort;                    // of the outermost call's keys, or of a nested one's, as upstream has one state for both
    std::size_t comparisons = 0;       // number of those of the last sweep of all geoms
    bool hasWalked = false;            // since pairs were brought up to date
    dxSapTemporaryLists temporary;

    // ---- The walk of the outermost call, which a call may repeat while nothing changes ------------------------------------------------

    dxSapWalk &sweep() { return m_sweep; }
    // Whether no member has come, gone, moved, or been enabled or disabled since.
    bool isSweepCurrent(const dxSpaceGeoms &geoms) const { return m_isSweepCurrent && m_switches == geoms.switches(); }
    void setSweepCurrent(const dxSpaceGeoms &geoms) {
        m_isSweepCurrent = true;
        m_switches = geoms.switches();
    }
    void invalidateSweep() { m_isSweepCurrent = false; }
    // Frees its memory.
    void discardSweep() {
        m_isSweepCurrent = false;
        m_sweep = dxSapWalk(axes);
    }
    // Whether the outermost call in progress delivers it.
    bool isSweepDelivered() const { return m_isSweepDelivered; }
    void noteSweepDelivered() { m_isSweepDelivered = true; }

    // Requires a call at the beginning of each outermost call.
    void beginCall() {
        temporary.restart();
        m_isSweepDelivered = false;
    }

private:
    dxSapWalk m_sweep;
    bool m_isSweepCurrent = false, m_isSweepDelivered = false;
    std::uint64_t m_switches = 0;  // dxSpaceGeoms::switches() when it became current
};
