// Which pairs may be collided away from the thread that the user's code runs on, and how.
//
// Upstream's colliders read two geoms and write contacts. Three things stand against running them anywhere:
//  - they call the user: classes of the user, overridden colliders, callbacks of meshes and height fields;
//  - they lead to other geoms: geom transforms, spaces;
//  - they write to the geoms: a mesh with temporal coherence keeps lists; a height field uses buffers of its own and
//    turns the other geom into its frame while it tests it.
// The first two kinds and coherent meshes stay on the user's thread. A pair with a height field is collided as a
// pair of private copies.
#pragma once

#include <cstdint>
#include <memory>

#include <ode/ode.h>

// Whether no collider of the pair calls the user, leads elsewhere or writes to the geoms, once copies are used.
bool dxMayCollideAnywhere(const dxGeom &a, const dxGeom &b);

// What the user may change about a geom in a callback without moving it, and colliders read: flags of rays, the
// data of meshes. Where it is the same, and the geom has not moved, dCollide gives the same contacts.
std::uint64_t dxColliderState(const dxGeom &geom);

// Scratch memory of one worker.
class dxColliderCopies {
public:
    dxColliderCopies();
    ~dxColliderCopies();
    dxColliderCopies(dxColliderCopies &&) noexcept;

    // dCollide for a pair that may be collided anywhere. Leaves both geoms untouched.
    int collide(dxGeom &a, dxGeom &b, int flags, dContactGeom *contacts, int skip);

private:
    class Terrain;
    std::unique_ptr<Terrain> m_terrain;  // made when the first height field comes
};
