// Pairs of spheres that touch, each pair far from all others: as many near-callbacks that share no body. Every sphere
// has a body.
#pragma once

#include <ode/ode.h>

class SphereRows {
public:
    static constexpr int kPairs = 64;

    explicit SphereRows(dSpaceID space) : m_world(dWorldCreate()), m_space(space) {
        for (int i = 0; i < 2 * kPairs; ++i) {
            const dGeomID ball = dCreateSphere(m_space, 0.5);
            const dBodyID body = dBodyCreate(m_world);
            dGeomSetBody(ball, body);
            dBodySetPosition(body, 10.0 * (i / 2), 0.8 * (i % 2), 0);
        }
    }
    ~SphereRows() {
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    SphereRows(const SphereRows &) = delete;
    SphereRows &operator=(const SphereRows &) = delete;

    dWorldID world() const { return m_world; }
    dSpaceID space() const { return m_space; }

private:
    dWorldID m_world;
    dSpaceID m_space;
};
