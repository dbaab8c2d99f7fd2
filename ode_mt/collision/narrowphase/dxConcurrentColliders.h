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

// Returns whether later calls can find out that the arrays which colliders of such a pair read have not changed. Arrays of the program's own, which
// it may write to without a call, are too large to compare if they are those of meshes, or samples of height fields that were not copied.
bool dxKnowsArrays(const dxGeom &a, const dxGeom &b);

// Returns whether the geom has data in an object that the program may destroy while it keeps the geom but does not collide it:
// such data may be accessed only if no such object has been destroyed (dxSilentChanges) since the program collided the
// geom.
bool dxHasDataOfProgram(const dxGeom &geom);

// Returns the state that colliders read and the user may change in a callback without moving the geom: flags of rays and the data
// of meshes. dCollide gives the same contacts if this state is the same, the geom has not moved, and the arrays of a convex geom are those of the
// copy (dxConvexArrays). dxSilentChanges counts changes of the samples of height fields.
std::uint64_t dxColliderState(const dxGeom &geom);

// Scratch memory of one worker.
class dxColliderCopies {
public:
    dxColliderCopies();
    ~dxColliderCopies();
    dxColliderCopies(dxColliderCopies &&) noexcept;

    // Arrays that are read instead of those of convex geoms; NULL: the program's.
    struct Arrays {
        const dxConvexArrays::Copy *a = nullptr, *b = nullptr;
    };

    // dCollide for a pair that may be collided on any thread. It does not write to the geoms.
    int collide(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip);

private:
    class Terrain;
    int collideWithTerrain(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip);

    std::unique_ptr<Terrain> m_terrain;  // made for the first height field
};
