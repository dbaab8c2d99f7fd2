// Worlds whose joints are hard (cfm 0) and say the same twice, or contradict one another: chains with each hinge made twice, closed linkages with
// motors and stops, towers of infinite friction, fixed joints of bodies that were moved in between. Drawn by a seed.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <random>
#include <vector>

class HardWorld {
public:
    enum class Scene { DoubleHinges, Linkage, Tower, FixedJoints };
    static constexpr unsigned kScenes = 4;

    struct Shape {
        bool isContradictory = true;  // false: rows only repeat one another, as long as nothing has moved
        unsigned maxLinks = 60;
        bool hasLimits = true;  // of chains; false: no motors and stops
    };

    explicit HardWorld(unsigned seed) : HardWorld(seed, Shape()) {}
    HardWorld(unsigned seed, const Shape &shape);
    ~HardWorld();
    HardWorld(const HardWorld &) = delete;
    HardWorld &operator=(const HardWorld &) = delete;

    dWorldID world() const { return m_world; }

    // One or two islands, beside the others.
    void add(Scene scene);
    void addAtRandom() { add(static_cast<Scene>(m_random() % kScenes)); }

    void collide();

    // Positions, orientations, velocities.
    std::vector<dReal> state() const;

private:
    bool chance(unsigned one) { return m_random() % one == 0; }
    dReal between(double low, double high) { return dReal(std::uniform_real_distribution<double>(low, high)(m_random)); }
    dReal drawMass();

    dBodyID addBox(dReal x, dReal y, dReal z, dReal sizeX, dReal sizeY, dReal sizeZ, bool isSolid);
    dJointID addHinge(dBodyID one, dBodyID other, dReal x, dReal y, dReal z);
    void limit(dJointID hinge);
    void addChain(dReal y);
    void addLinkage(dReal y);
    void addTower(dReal y);
    void addFixedJoints(dReal y);

    std::mt19937 m_random;
    const Shape m_shape;
    const dWorldID m_world;
    const dSpaceID m_space;
    const dJointGroupID m_contacts;
    std::vector<dBodyID> m_bodies;
    dReal m_nextY = 0;
    double m_massRange = 0;  // powers of ten
};
