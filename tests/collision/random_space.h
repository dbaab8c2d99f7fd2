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

enum class Kind { Simple, Hash, QuadTree, Sweep };

struct Recipe {
    unsigned seed;
    Kind kind;
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

    // The same of a few geoms, in the space and outside, and of another space, each collided with the space.
    std::vector<std::pair<int, int>> probe();

    // The numbers of the space's geoms as dSpaceGetGeom lists them, which it does not for a quad tree.
    std::vector<int> list() const;

private:
    dReal uniform(dReal low, dReal high) { return std::uniform_real_distribution<dReal>(low, high)(m_random); }
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(m_random); }
    bool chance(double probability) { return std::bernoulli_distribution(probability)(m_random); }
    dReal size() { return std::pow(dReal(10), uniform(m_smallest, m_largest)); }
    dSpaceID makeSpace(Kind kind);
    dSpaceID makeQuadTree();
    dSpaceID makeSweep();
    void chooseBounds();
    void addProbes();
    void probeWith(dGeomID geom);
    void breathe(int frame);
    dGeomID make();
    dGeomID makeShape();
    dGeomID makeSolid();
    dGeomID makeOddity();
    void makeOddBounds(dReal *box);
    dReal oddBound();
    dReal onGrid(dReal coordinate);
    dSpaceID makeSubspace();
    void place(dGeomID geom);
    void change(dGeomID &geom);
    bool hasList() const { return m_kind == Kind::Simple || m_kind == Kind::Hash; }
    void number(dGeomID geom);
    void reenter(dGeomID geom);
    static void met(void *self, dGeomID a, dGeomID b);
    static void oddBox(dGeomID geom, dReal aabb[6]);
    static int oddTest(dGeomID geom, dGeomID other, dReal aabb[6]);

    std::mt19937 m_random;
    const Kind m_kind;
    const bool m_isCrowd;     // few geoms overlap most others
    bool m_hasGrid = false;   // many equal bounds, zeros of both signs among them
    int m_oddClass = 0;       // of geoms that have any box
    double m_oddities = 0;    // how many of the geoms are such
    dWorldID m_world;
    dSpaceID m_space;
    int m_breath;  // geoms that come or go at a frame, 0 if none
    dReal m_smallest, m_largest;  // sizes, as powers of ten
    dReal m_extent;               // half the edge of the cube in which geoms are placed
    dVector3 m_centre;
    int m_nextNumber = 0;
    std::vector<dGeomID> m_geoms;
    dSpaceID m_others;               // outside the space, more geoms than a small one has
    std::vector<dGeomID> m_probes;   // outside, too
    dGeomID m_mover = nullptr;       // the probe that may move in a callback
    std::vector<std::pair<int, int>> m_met;
    unsigned m_togglesLeft = 0;
};

}  // namespace collision
