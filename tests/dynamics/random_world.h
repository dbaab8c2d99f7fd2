// Worlds drawn by a seed, for tests that step the same world with two steppers: bodies of all kinds, joints of all types
// between them and to the world, with motors, stops, friction and feedback.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

class RandomWorld {
public:
    struct Shape {
        unsigned bodies, joints;
        bool isExtreme = false;  // forces beyond the range of numbers, and none at all
        bool isQuiet = false;    // no finite rotation
    };

    RandomWorld(const Shape &shape, unsigned seed);
    ~RandomWorld();
    RandomWorld(const RandomWorld &) = delete;
    RandomWorld &operator=(const RandomWorld &) = delete;

    dWorldID world() const { return m_world; }

    // Before each step: forces, and motors that change their minds.
    void push();

    // Every number that a step writes, by name of the object; a NaN is one whatever its bits.
    std::vector<std::uint64_t> state() const;

private:
    void addBody();
    void addJoint();
    dJointID makeJoint(unsigned kind);
    dJointID makeContact();
    void setLimits(dJointID joint, void (*set)(dJointID, int, dReal), int group);
    void setAxes(dJointID joint, unsigned kind);

    bool chance(unsigned one) { return m_random() % one == 0; }
    double number() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }
    void draw(dReal *vector) {
        for (int i = 0; i < 3; ++i) vector[i] = dReal(number());
    }

    const Shape m_shape;
    std::mt19937 m_random;
    dWorldID m_world;
    std::vector<dBodyID> m_bodies;
    std::vector<dJointID> m_joints;
    std::vector<std::unique_ptr<dJointFeedback>> m_feedbacks;
};
