// The last samples of a value, one a frame: their average and the speed at which the value changes.
//
// Both are taken over at most `window` samples and are defined from the start (0), where the first
// ODE_MT divided by a counter that nothing had set. They are computed from the samples that are in the
// window, not carried along as running sums: nothing drifts, and a NaN or an infinity counts only until it
// has left. Memory grows with the samples, up to the window; then nothing is allocated.
#pragma once

#include <cstddef>
#include <vector>

class dxSampleWindow {
public:
    explicit dxSampleWindow(unsigned window) : m_window(window > 0 ? window : 1) {}

    void add(double value);
    void clear();

    unsigned window() const { return m_window; }  // frames; at least 1
    unsigned size() const { return static_cast<unsigned>(m_samples.size()); }

    double average() const;  // 0 without samples
    double speed() const;    // (newest - oldest) / frames between them; 0 with fewer than two samples

private:
    double oldest() const { return m_samples[m_next % m_samples.size()]; }
    double newest() const { return m_samples[(m_next + m_samples.size() - 1) % m_samples.size()]; }

    unsigned m_window;
    std::vector<double> m_samples;  // a ring once it is full
    std::size_t m_next = 0;         // where the next sample goes in a full ring; the oldest is there
};
