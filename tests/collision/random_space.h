// A world of random geoms in one space, changed at random before each collision. Everything follows from the
// seed and the library's own answers, so two libraries that order pairs alike report the same.
#pragma once

#include <cstdint>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <ode/ode.h>

namespace collision {

struct Recipe {
    unsigned seed;
    bool hash;  // else a simple space
    int geoms;
    int frames;
    bool breathes;  // grows to twice its size and shrinks again, time after time
};

class RandomSpace {
public:
    explicit RandomSpace(const Recipe &recipe);
    ~RandomSpace();
    RandomSpace(const RandomSpace &) = delete;
    RandomSpace &operator=(const RandomSpace &) = delete;

    void changeSomething(int frame);

    // Collides once; the numbers of the geoms of each callback, in order.
    std::vector<std::pair<int, int>> collide();

    // The numbers of the space's geoms as dSpaceGetGeom lists them.
    std::vector<int> list() const;

private:
    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(m_random); }
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(m_random); }
    bool chance(double probability) { return std::bernoulli_distribution(probability)(m_random); }
    dReal size() { return std::pow(dReal(10), uniform(m_smallest, m_largest)); }
    void breathe(int frame);
    dGeomID make();
    dGeomID makeShape();
    dSpaceID makeSubspace();
    void place(dGeomID geom);
    void change(dGeomID &geom);
    static void met(void *self, dGeomID a, dGeomID b);

    std::mt19937 m_random;
    dWorldID m_world;
    dSpaceID m_space;
    int m_breath;  // geoms that come or go at a frame, 0 if none
    dReal m_smallest, m_largest;  // sizes, as powers of ten
    dReal m_extent;               // half the edge of the cube in which geoms are placed
    dVector3 m_centre;
    int m_nextNumber = 0;
    std::vector<dGeomID> m_geoms;
    std::vector<std::pair<int, int>> m_met;
    unsigned m_togglesLeft = 0;
};

}  // namespace collision
