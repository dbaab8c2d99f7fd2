// What is timed: the stages of a frame, the groups of stages that are reported, and how the times of frames are distributed.
#pragma once

#include <array>
#include <map>
#include <vector>

namespace bench {

// Wall-clock seconds spent in the stages of some frames; see scenes::Scene.
struct StageTimes {
    double control = 0, collide = 0, step = 0, finish = 0;
    double callbacks = 0;  // part of collide: in near-callbacks, of all threads; 0 if they were not timed

    StageTimes &operator+=(const StageTimes &other) {
        control += other.control;
        collide += other.collide;
        step += other.step;
        finish += other.finish;
        callbacks += other.callbacks;
        return *this;
    }
};

enum class Part { Frame, Collision, Dynamics, Overhead, Callbacks, OutsideCallbacks };

constexpr std::array<Part, 6> kParts = {Part::Frame,    Part::Collision, Part::Dynamics,
                                        Part::Overhead, Part::Callbacks, Part::OutsideCallbacks};

// The last two are known only if callbacks were timed.
inline std::vector<Part> partsToReport(bool callbacksTimed) {
    return {kParts.begin(), kParts.end() - (callbacksTimed ? 0 : 2)};
}

inline const char *nameOf(Part part) {
    switch (part) {
        case Part::Frame:
            return "frame";
        case Part::Collision:
            return "collision";
        case Part::Dynamics:
            return "dynamics";
        case Part::Overhead:
            return "overhead";
        case Part::Callbacks:
            return "callbacks";
        case Part::OutsideCallbacks:
            return "outside_callbacks";
    }
    return "";
}

inline double secondsOf(const StageTimes &times, Part part) {
    switch (part) {
        case Part::Frame:
            return times.control + times.collide + times.step + times.finish;
        case Part::Collision:
            return times.collide;
        case Part::Dynamics:
            return times.step;
        case Part::Overhead:
            return times.control + times.finish;
        case Part::Callbacks:
            return times.callbacks;
        case Part::OutsideCallbacks:
            return secondsOf(times, Part::Frame) - times.callbacks;
    }
    return 0;
}

// How frame times are distributed: a histogram with bins of equal ratio, so that microseconds and seconds have the same resolution
// and millions of frames take no memory.
class FrameTimes {
public:
    static constexpr int kBinsPerDoubling = 8;  // a bin is 9 % wide

    void add(double seconds);
    void add(int bin, long frames) { m_counts[bin] += frames; }
    FrameTimes &operator+=(const FrameTimes &other);

    // Number of frames by bin: bin b holds times from lowerBound(b) to lowerBound(b + 1). Only bins that hold some.
    const std::map<int, long> &counts() const { return m_counts; }
    static double lowerBound(int bin);  // s

private:
    std::map<int, long> m_counts;
};

}  // namespace bench
