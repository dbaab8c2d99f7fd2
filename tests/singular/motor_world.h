// A world of two or three bodies and more motors than they have degrees of freedom, without softness: the
// matrix of its step is singular, and the solver divides by zero. What pushes the bodies decides how far its
// numbers get.
#pragma once

#include "scenarios/dice.h"

#include <ode/ode.h>

#include <vector>

namespace singular {

enum class Push { Small, Huge, NotANumber };
constexpr Push allPushes[] = {Push::Small, Push::Huge, Push::NotANumber};
const char *nameOf(Push push);

class MotorWorld {
public:
    MotorWorld(Push push, int seed);
    ~MotorWorld() { dWorldDestroy(m_world); }
    MotorWorld(const MotorWorld &) = delete;
    MotorWorld &operator=(const MotorWorld &) = delete;

    void push();
    void step() { dWorldStep(m_world, 0.01); }
    const std::vector<dBodyID> &bodies() const { return m_bodies; }

private:
    void addBody();
    void addJoint();
    void createJoint(dBodyID one, dBodyID other);
    void addAxes(dJointID motor, bool angular, bool relative);
    dReal strength();

    Push m_push;
    exactness::Dice m_dice;
    dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};

}  // namespace singular
