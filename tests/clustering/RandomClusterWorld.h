// A random world in one space, changed at random before each frame: boxes that move, far too, and leave the
// grid; geoms made, destroyed, resized, given a body and freed of it; nested spaces; robots of jointed bodies
// and of bodies with several geoms; joints made and broken; planes, whose boxes are infinite; walls and floors.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <ode/ode.h>

#include "ReferenceClusters.h"

class RandomClusterWorld {
public:
    RandomClusterWorld(unsigned seed, bool hash);
    ~RandomClusterWorld();
    RandomClusterWorld(const RandomClusterWorld &) = delete;
    RandomClusterWorld &operator=(const RandomClusterWorld &) = delete;

    dSpaceID space() const { return m_space; }
    const std::vector<dGeomID> &geoms() const { return m_geoms; }
    std::vector<ReferenceInhabitant> inhabitants() const;  // in the order of geoms()

    // Something has always changed afterwards.
    void change();

private:
    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(m_random); }
    int below(std::size_t end) { return std::uniform_int_distribution<int>(0, static_cast<int>(end) - 1)(m_random); }
    bool chance(double probability) { return std::bernoulli_distribution(probability)(m_random); }
    dReal size() { return std::pow(dReal(10), uniform(-1, dReal(0.5))); }
    void make();
    void makeRobot();
    void makeNested();
    dGeomID makeShape();
    void add(dGeomID geom);
    void place(dGeomID geom);
    void changeOne();
    void changeJoint();
    void leaveAndComeBack(std::size_t i);

    std::mt19937 m_random;
    dWorldID m_world;
    dSpaceID m_space;
    dReal m_extent = 20;
    std::vector<dGeomID> m_geoms;
    std::vector<int> m_ids;  // of m_geoms
    std::vector<dJointID> m_joints;
    int m_nextId = 0;
};
