// A number that a plan asks of each run.
//
//   contacts, awake, energy, kinetic_energy, potential_energy     of the world; awake: how many bodies do not sleep. J
//   BODY.position.x, .velocity.y, .angular_velocity.z, .height, .speed    of a body: m, m/s, rad/s
//   JOINT.angle, JOINT.rate, JOINT.extension                               of a hinge, of a hinge, of a slider: rad, rad/s, m
//   reading[N]                                                             of a sensor
//
// BODY and JOINT are names of an SDF world (model::link, model::joint), or body[N] and joint[N] in the order of creation. As it stands the
// number is that after the last frame; "max X", "min X" and "mean X" are over all frames.
#pragma once

#include "scenes/scene.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace batch {

struct ObservableError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

struct Observable {
    enum class Over { End, Max, Min, Mean };

    std::string name;
    Over over;
    std::string what;  // the expression behind max, min or mean
};

// Throws ObservableError if the expression means nothing in any world.
Observable readObservable(const std::string &name, const std::string &expression);

// What a scene's number is read by. Throws ObservableError if the scene has no such thing.
std::function<double()> findReading(const Observable &observable, const scenes::Scene &scene);

}  // namespace batch
