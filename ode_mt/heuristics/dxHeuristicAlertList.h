// The alerts of one heuristic, in the order in which they were added.
//
// All alerts are checked against a sample before the first callback is called, so that no callback has an
// influence on which alerts a frame raises. Callbacks may add and remove alerts: one that was added is
// checked from the next sample on; one that was removed is not delivered any more, also in this frame.
//
// Added numbers ascend, so the list is sorted by them. Removing while alerts are delivered only clears
// the callback; the entry itself goes afterwards.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "heuristics/dxHeuristicAlert.h"
#include "heuristics/dxScopedFlag.h"

using dxAlertId = std::uint64_t;  // 0: none

template <class Callback>
class dxHeuristicAlertList {
public:
    // 0 if the alert is not valid. The callback has to live until the alert is removed.
    dxAlertId add(const dxHeuristicAlert &alert, Callback &callback) {
        if (!alert.valid()) return 0;
        m_entries.push_back({++m_lastId, alert, &callback, false});
        return m_lastId;
    }

    bool remove(dxAlertId id) {
        const auto entry = std::lower_bound(m_entries.begin(), m_entries.end(), id,
                                            [](const Entry &e, dxAlertId wanted) { return e.id < wanted; });
        if (entry == m_entries.end() || entry->id != id || entry->callback == nullptr) return false;
        entry->callback = nullptr;
        if (!m_delivering) sweep();
        return true;
    }

    std::size_t size() const {
        return static_cast<std::size_t>(std::count_if(m_entries.begin(), m_entries.end(), alive));
    }

    void rearm() {
        for (Entry &entry : m_entries) entry.alert.rearm();
    }

    template <class Heuristic>
    void deliver(const dxAlertSample &sample, Heuristic &heuristic) {
        for (Entry &entry : m_entries) entry.fired = entry.alert.fires(sample);
        {
            const dxScopedFlag delivering(m_delivering);
            call(heuristic);
        }
        sweep();
    }

private:
    struct Entry {
        dxAlertId id;
        dxHeuristicAlert alert;
        Callback *callback;  // null: removed
        bool fired;
    };

    static bool alive(const Entry &entry) { return entry.callback != nullptr; }

    template <class Heuristic>
    void call(Heuristic &heuristic) {
        // Copies, because a callback that adds an alert moves the entries.
        for (std::size_t i = 0, end = m_entries.size(); i < end; ++i) {
            if (!m_entries[i].fired || !alive(m_entries[i])) continue;
            const dxHeuristicAlert alert = m_entries[i].alert;
            m_entries[i].callback->alertCallback(heuristic, alert);
        }
    }

    void sweep() {
        m_entries.erase(
            std::remove_if(m_entries.begin(), m_entries.end(), [](const Entry &e) { return !alive(e); }),
            m_entries.end());
    }

    std::vector<Entry> m_entries;
    dxAlertId m_lastId = 0;
    bool m_delivering = false;
};
