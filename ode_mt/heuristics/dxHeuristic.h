// A value that is observed or tuned, one sample a frame, with alerts (thesis, figure A.3).
//
//   frame:  heuristic.setValue(clusterCount);   as often as it changes
//           manager.tick();                     samples the value, then calls back whom it concerns
//
// Average and speed of change are taken over the last `window` frames (dxSampleWindow) and are 0 before there
// are samples. Values count as doubles: integers are exact up to 2^53.
#pragma once

#include <cstdint>
#include <type_traits>

#include "heuristics/dxHeuristicAlertList.h"
#include "heuristics/dxHeuristicBase.h"
#include "heuristics/dxSampleWindow.h"
#include "heuristics/HeuristicAlertCallback.h"

template <class T>
class dxHeuristic final : public dxHeuristicBase {
    static_assert(std::is_arithmetic<T>::value, "a heuristic's value is a number");

public:
    static constexpr unsigned kDefaultWindow = 10;  // frames, the interval that the thesis's manager used

    // A window of 0 frames is taken as 1.
    explicit dxHeuristic(T initial, unsigned window = kDefaultWindow)
        : m_initial(initial), m_value(initial), m_window(window) {}

    // What the next tick samples. Stays until it is set again; reset() brings back the initial value.
    void setValue(T value) { m_value = value; }
    T value() const { return m_value; }

    std::uint64_t samples() const { return m_samples; }  // since the creation or the last reset
    double average() const { return m_window.average(); }
    double speed() const { return m_window.speed(); }      // per frame
    unsigned window() const { return m_window.window(); }  // frames

    // 0 if the alert means nothing (dxHeuristicAlert::valid). The callback has to outlive the alert.
    dxAlertId addAlert(const dxHeuristicAlert &alert, HeuristicAlertCallback<T> &callback) {
        return m_alerts.add(alert, callback);
    }
    bool removeAlert(dxAlertId id) { return m_alerts.remove(id); }  // false: there is none
    std::size_t alerts() const { return m_alerts.size(); }

private:
    void judge() override {
        const double value = static_cast<double>(m_value);
        const double previous = m_sampled;
        m_sampled = value;
        m_window.add(value);
        ++m_samples;
        m_alerts.deliver({m_samples, value, previous, m_window.speed()}, *this);
    }

    void forget() override {
        m_value = m_initial;
        m_samples = 0;
        m_window.clear();
        m_alerts.rearm();
    }

    const T m_initial;
    T m_value;
    double m_sampled = 0;  // the newest sample
    std::uint64_t m_samples = 0;
    dxSampleWindow m_window;
    dxHeuristicAlertList<HeuristicAlertCallback<T>> m_alerts;
};
