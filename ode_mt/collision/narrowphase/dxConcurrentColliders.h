// The pairs that may be collided on any thread, and how.
//
// Upstream's colliders read two geoms and write contacts. There are three obstacles to running them on any thread:
//  - they call the user: classes of the user, overridden colliders, callbacks of meshes and height fields;
//  - they lead to other geoms: geom transforms, spaces;
//  - they write to the geoms: a mesh with temporal coherence keeps lists; a height field uses buffers of its own and
//    transforms the other geom into its frame while it tests it.
// The first two kinds and coherent meshes stay on the user's thread. A pair with a height field is collided
// as a pair of private copies.
#pragma once

#include <cstdint>
#include <memory>

#include <ode/ode.h>

#include "collision/narrowphase/dxConvexArrays.h"

// Returns whether no collider of the pair calls the user, leads to other geoms, or writes to the geoms if copies are
// used.
bool dxMayCollideConcurrently(const dxGeom &a, const dxGeom &b);

// Whether what colliders of such a pair read can be known to be unchanged later, as far as arrays are concerned that
// are the program's own, so that it may write to them without a call: those of meshes, and samples of height fields
// that were not copied, are too many to compare.
bool dxKnowsArrays(const dxGeom &a, const dxGeom &b);

// Whether the geom has data in an object that the program may destroy while it has the geom, but does not collide it:
// such data may be accessed only if no such object has been destroyed (dxSilentChanges) since the program collided the
// geom.
bool dxHasDataOfProgram(const dxGeom &geom);

// What the user may change about a geom in a callback without moving it, and colliders read: flags of rays and the data
// of meshes. Where it is the same, the geom has not moved, and the arrays of a convex geom are those of the copy
// (dxConvexArrays), dCollide gives the same contacts. Whether samples of height fields have changed is told by
// dxSilentChanges.
std::uint64_t dxColliderState(const dxGeom &geom);

// Scratch memory of one worker.
class dxColliderCopies {
public:
    dxColliderCopies();
    ~dxColliderCopies();
    dxColliderCopies(dxColliderCopies &&) noexcept;

    // What is read instead of the arrays of convex geoms; NULL: the program's.
    struct Arrays {
        const dxConvexArrays::Copy *a = nullptr, *b = nullptr;
    };

    // dCollide for a pair that may be collided on any thread. It does not write to the geoms.
    int collide(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip);

private:
    class Terrain;
    int collideWithTerrain(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip);

    std::unique_ptr<Terrain> m_terrain;  // made when the first height field comes
};
