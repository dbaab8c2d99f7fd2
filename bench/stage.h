// What is timed: the stages of a frame and the groups of stages that the thesis reports.
#pragma once

#include <array>

namespace bench {

// Wall-clock seconds spent in the stages of some frames; see scenes::Scene.
struct StageTimes {
    double control = 0, collide = 0, step = 0, finish = 0;

    StageTimes &operator+=(const StageTimes &other) {
        control += other.control;
        collide += other.collide;
        step += other.step;
        finish += other.finish;
        return *this;
    }
};

enum class Part { Frame, Collision, Dynamics, Overhead };

constexpr std::array<Part, 4> kParts = {Part::Frame, Part::Collision, Part::Dynamics, Part::Overhead};

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
    }
    return 0;
}

}  // namespace bench
