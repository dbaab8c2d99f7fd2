// The collider of two boxes, with SIMD: the same bits as upstream's dCollideBoxBox and dBoxBox (docs/collision.md). The kernel, dxBoxContacts.cpp,
// computes the contacts; dxBoxBox.cpp gives them to the program as upstream does.
//
// The separating-axis test (Gottschalk, Lin and Manocha, OBBTree, 1996) looks for an axis of 15 on which the boxes are apart: the
// normals of the faces of both, and the products of their edges. If there is none, the axis on which they overlap least is that of
// the contacts. If it belongs to two edges, the contact is where these are closest; if it is the normal of a face (the reference
// face), the contacts are the corners of the opposite face of the other box (the incident face), clipped by the reference face
// (Sutherland and Hodgman, 1974).
//
// Threading: no state; any number of threads at a time.
#pragma once

#include <ode/collision.h>

struct dxBoxPair {
    const dReal *position[2], *rotation[2], *sides[2];
};

struct dxBoxContacts {
    static constexpr int kMax = 8;

    // Upstream's code: 1 to 3 are faces of the first box, 4 to 6 of the second, 7 to 15 are edges; 0: the boxes are apart.
    int code;
    dReal normal[3];  // from the first box to the second
    dReal depth;      // largest one along the normal

    int count;  // of points: at most kMax; 0 with a code happens by rounding
    // For each point; every array has memory for four more at its end.
    dReal position[3][kMax + 4];  // by coordinate
    dReal depths[kMax + 4];       // never negative
    dReal onFace[2][kMax + 4];    // places on the reference face, by coordinate; not with edges
};

// Returns whether this processor has the vectors that the kernel needs.
bool dxHasBoxKernel();

// Returns false for boxes that are left to upstream: those for which a sum of the test is NaN, or infinite on all faces; all on a processor
// without such vectors. Requires rounding to nearest (dxIsPlainFloatMode) and no trapped exceptions: axes are tested that upstream does not
// reach.
bool dxFindBoxContacts(const dxBoxPair &boxes, dxBoxContacts &contacts);

// Does what dBoxBox does and returns its result; or returns -1 if nothing was done and upstream has to answer.
int dxBoxBox(const dxBoxPair &boxes, dReal *normal, dReal &depth, int &code, int flags, dContactGeom *contacts, int skip);
