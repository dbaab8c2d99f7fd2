// What a heuristic is asked to report (thesis, figure A.4).
//
//   everyFrames(n)             at frames n, 2n, 3n, ... of the heuristic, counted from its creation or last
//                              reset, pauses left out (the first ODE_MT meant 10 and took 11)
//   valueChange()              the value differs from that of the frame before
//   valueBelow(t), valueAbove(t)    the value has come to be < t, > t
//   speedBelow(t), speedAbove(t)    the speed of change, per frame, has come to be < t, > t
//
// The last four are triggered by the edge: they fire when the condition begins to hold (at the first sample
// if it holds from the start) and again only after a sample for which it did not hold. A NaN is no number:
// it is neither below nor above anything and leaves the edge as it was; becoming NaN is one change.
#pragma once

#include <cstdint>

// What an alert is checked against.
struct dxAlertSample {
    std::uint64_t frame;  // 1 for the first sample
    double value;
    double previous;  // of the frame before; of no meaning in frame 1
    double speed;     // per frame
};

class dxHeuristicAlert {
public:
    enum class Kind { FixedInterval, ValueChange, ValueBelow, ValueAbove, SpeedBelow, SpeedAbove };

    static dxHeuristicAlert everyFrames(unsigned frames) { return {Kind::FixedInterval, frames, 0}; }
    static dxHeuristicAlert valueChange() { return {Kind::ValueChange, 0, 0}; }
    static dxHeuristicAlert valueBelow(double threshold) { return {Kind::ValueBelow, 0, threshold}; }
    static dxHeuristicAlert valueAbove(double threshold) { return {Kind::ValueAbove, 0, threshold}; }
    static dxHeuristicAlert speedBelow(double threshold) { return {Kind::SpeedBelow, 0, threshold}; }
    static dxHeuristicAlert speedAbove(double threshold) { return {Kind::SpeedAbove, 0, threshold}; }

    // False if it could never mean anything: an interval of 0 frames, a threshold that is NaN.
    bool valid() const;

    Kind kind() const { return m_kind; }
    double threshold() const { return m_threshold; }
    unsigned interval() const { return m_interval; }  // frames

    // To be called for every sample, in order: remembers the edge.
    bool fires(const dxAlertSample &sample);
    void rearm() { m_beyond = false; }

private:
    dxHeuristicAlert(Kind kind, unsigned interval, double threshold)
        : m_kind(kind), m_interval(interval), m_threshold(threshold) {}

    bool crosses(double number);

    Kind m_kind;
    unsigned m_interval;
    double m_threshold;
    bool m_beyond = false;  // the condition held for the last number
};
