// Tells whether a space is walked as upstream does, because most of its geoms move. Then nothing is kept up to date that a walk does not need, above
// all no ranks.
//
// Threading: one thread at a time begins walks, moves geoms and ends walks. Several threads may query the space (dSpaceCollide2); one of them ends
// the walks when there have been enough queries to pay for the ranks.
#pragma once

#include <algorithm>
#include <atomic>
#include <climits>
#include <mutex>
#include <utility>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "core/dxPublished.h"

class dxWalking {
public:
    operator bool() const { return m_isOn; }
    void set(bool isOn) {
        if (!isOn) m_restedCalls = 0;
        m_isOn = isOn;
    }

    // Requires a call in each cleaning, with the number of geoms that it cleans, of `all`.
    void noteMoved(int geoms, int all) {
        m_moved = std::min(m_moved + geoms, all);
        if (geoms != 0) m_queries.store(0, std::memory_order_relaxed);
    }
    // Requires a call in each dSpaceCollide, before geoms are cleaned.
    void noteCollided() { m_isCollided = true; }
    // Requires a call in each cleaning. Returns whether the cleaning is for a query, the space has not been collided since the last cleaning, and so
    // many of its geoms move that a walk answers the query fastest.
    bool isForQuery(int moved, int all) {
        return !std::exchange(m_isCollided, false) && 4 * moved >= dxBroadphaseThresholds::kMovedOfFourQueried * all;
    }

    // Returns the number of geoms cleaned since the last call of takeMoved(), at most all. A geom counts each time that it was cleaned.
    int takeMoved() { return std::exchange(m_moved, 0); }
    // Requires a call in each dSpaceCollide, with the number of geoms that have moved since the last one. Returns whether walks should end, because
    // few geoms have moved for kMinCallsRested calls. (So a program that collides a space twice in each frame keeps its walks.) `minMoved`:
    // dxMinMovedToWalk().
    bool hasRested(int moved, int minMoved) {
        m_restedCalls = dxHaveFewMoved(moved, minMoved) ? m_restedCalls + 1 : 0;
        return minMoved == INT_MAX || m_restedCalls >= dxBroadphaseThresholds::kMinCallsRested;
    }

    // Requires a call in each query of a walked space. Calls stop(), which must end the walks, if there have been many queries since a geom moved.
    // Other threads go on walking meanwhile.
    template <class Stop>
    void query(Stop stop) {
        if (++m_queries <= dxBroadphaseThresholds::kMaxWalksUnranked) return;
        const std::unique_lock<std::mutex> alone(m_stopping, std::try_to_lock);
        if (alone && m_isOn) stop();
    }

private:
    std::atomic<int> m_queries{0};
    int m_moved = 0, m_restedCalls = 0;
    bool m_isCollided = false;
    dxPublished<bool> m_isOn{false};
    std::mutex m_stopping;  // only try_lock is used
};
