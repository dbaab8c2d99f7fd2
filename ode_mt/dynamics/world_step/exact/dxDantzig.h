// The LCP solver of the exact step: Dantzig's algorithm with upstream's bits, in a layout made for vectors.
// docs/exact.md tells how it works and why the bits are those of upstream's dxSolveLCP (ode/src/lcp.cpp).
//
// Source: Baraff, "Fast contact force computation for nonpenetrating rigid bodies", SIGGRAPH 1994, which applies the principal pivoting
// of Cottle and Dantzig, "Complementary pivot theory of mathematical programming", 1968.
#pragma once

#include <ode/common.h>

class dxWorldProcessMemArena;
struct dxLargeIslandWorkers;

// Solves A x = b + w with, for each i, lo(i) <= x(i) <= hi(i), where w(i) >= 0 if x(i) = lo(i), w(i) <= 0 if
// x(i) = hi(i), and w(i) = 0 otherwise.
//
//   islandWorkers  workers for large problems; null: the calling thread alone
//   memory      the size of upstream's dxEstimateSolveLCPMemoryReq is allocated from it, as in upstream
//   n           rows, at least 1
//   A           symmetric, positive definite; the lower triangle is read; rows start dPAD(n) elements apart
//   pairsBX     b(i), x(i) for each i; x is written, b may be
//   w           not used: upstream's interface
//   bilateral   how many of the first rows are bilateral; other bilateral ones may follow
//   pairsLoHi   lo(i) <= 0, hi(i) >= 0; those of friction rows may be written
//   normalOf    null, or for each i the row whose x(i) scales the limits of row i (friction), or -1
//
// Threading: reads and writes what it is given, and calls the message handler of the calling thread's island. Results
// do not depend on the workers.
void dxSolveDantzig(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *w,
                    unsigned bilateral, dReal *pairsLoHi, int *normalOf);

// The same, but neither reports anything nor calls upstream's solver: returns false where that would be necessary, and leaves all as it is.
// The limits of friction rows are written, since they are those of the normals' forces before friction.
bool dxTryDantzig(dxLargeIslandWorkers *islandWorkers, dxWorldProcessMemArena *memory, unsigned n, dReal *A, dReal *pairsBX, dReal *pairsLoHi,
                  int *normalOf);
