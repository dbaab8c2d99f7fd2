// What is timed: the stages of a frame and the groups of stages that the thesis reports.
#pragma once

#include <array>
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

}  // namespace bench
