// The matrix and the right-hand side of an island's LCP, from its Jacobian, for every instruction set:
//
//   A = J inv(M) J' + cfm/h,   b = c/h - J u,   u = v/h + inv(M) f
//
// Two joints have elements of A in common only if they share a body. Joints are taken in the order of their rows: each meets
// those before it, which follow it in its bodies' lists, and makes its rows of A up to the diagonal.
//
// A block of A, the rows of one joint by those of another, is made row by row with a lane for each column: so the Jacobian is
// kept by elements, too. Every element is a sum of six products in upstream's order; what the second body adds comes after
// what the first one has, also where two joints share both.
//
// Tried and dropped: lanes gathered from the Jacobian as joints write it, which takes as long as it saves.
#pragma once

#include <ode/common.h>

#include <cstddef>

// Lists of the joints that have rows on a body: each link is a joint as seen from one of its bodies. The lists are arrays of links, not of
// pointers, so that they need no initialisation but that of their heads.
namespace dxBodyLinks {

constexpr unsigned kSides = 2;
constexpr unsigned kNone = 0;  // ends a list

inline unsigned linkOf(unsigned joint, unsigned side) { return joint * kSides + side + 1; }
inline unsigned jointOf(unsigned link) { return (link - 1) / kSides; }
inline unsigned sideOf(unsigned link) { return (link - 1) % kSides; }

// The lists of all bodies.
struct Lists {
    unsigned *first = nullptr;  // by body
    unsigned *next = nullptr;   // by link - 1

    void add(unsigned body, unsigned link) const {
        next[link - 1] = first[body];
        first[body] = link;
    }
    unsigned after(unsigned link) const { return next[link - 1]; }
};

}  // namespace dxBodyLinks

constexpr unsigned kRowElements = 6;  // of a row of the Jacobian for one body: linear, then angular
constexpr unsigned kMaxJointRows = 6;

struct dxConstraintJoint {
    static constexpr unsigned kNoBody = ~0u;

    unsigned firstRow, rows;
    unsigned bodies[dxBodyLinks::kSides];  // the first is one, the second may be none
};

struct dxConstraintMatrixTask {
    const dxConstraintJoint *joints;
    unsigned jointCount;

    // For each joint kRowElements for each row on its first body, then for each on its second one.
    const dReal *jacobian;

    // By body: twelve elements, a 3 x 4 matrix whose element kInverseMass is the inverse mass.
    const dReal *inverseInertia;
    static constexpr unsigned kInverseMass = 3;

    const dReal *motions;  // u, kRowElements by body

    dReal *pairs;         // by row: c/h, which becomes b, and cfm/h
    dReal *matrix;        // A, lower triangle; where lanes end beyond an element, what lies there is read
    std::size_t rowSkip;  // between rows of A

    dReal *transposed;  // room for the Jacobian by elements: transposedSize()
    dxBodyLinks::Lists links;  // of each body's joints, the last one first

    static std::size_t transposedSize(std::size_t rows) { return dxBodyLinks::kSides * kRowElements * rows + kSlack; }
    static constexpr unsigned kSlack = 4;  // lanes that begin at the last element
};

// `mayUseLanes`: false where a lane that is not read must not raise a floating-point exception.
void dxMakeConstraintMatrix(const dxConstraintMatrixTask &task, bool mayUseLanes);
