// Spaces by the number of their kind, and geoms by numbers of their own, for programs that run on either library.
#pragma once

#include <cstdint>

#include <ode/ode.h>

constexpr const char *kKinds[] = {"simple", "hash", "sweep", "quadtree"};

inline dSpaceID createSpace(int kind) {
    const dVector3 centre = {0, 0, 0}, extents = {200, 200, 10};
    switch (kind) {
    case 0: return dSimpleSpaceCreate(nullptr);
    case 1: return dHashSpaceCreate(nullptr);
    case 2: return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    default: return dQuadTreeSpaceCreate(nullptr, centre, extents, 4);
    }
}

inline void setNumber(dGeomID geom, int number) { dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::uintptr_t>(number))); }
inline std::uint64_t numberOf(dGeomID geom) { return reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)); }

// Callbacks of a call: how many, and a sum over them that depends on their order.
struct SeenPairs {
    std::uint64_t sum = 0;
    long pairs = 0;

    void see(dGeomID a, dGeomID b) {
        sum = (sum ^ (numberOf(a) * 2048 + numberOf(b))) * 0x100000001b3u;
        ++pairs;
    }
};
