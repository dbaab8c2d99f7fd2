// How far forces are from a solution of an island's problem, computed from its rows and not from a matrix that was made or factorised.
#pragma once

#include <vector>

#include "dynamics/direct/dxBodyBlocks.h"

struct dxExactProblem;
struct dxInverseMass;

class dxRowResidual {
public:
    // w = J (inv(M) J' x + u) + cfm/h x - c/h. `forces` (x) by row; `inverseMasses` and `motions` (u) by tag.
    void find(const dxExactProblem &problem, const dxInverseMass *inverseMasses, const dxBodyVectors &motions,
              const std::vector<double> &forces);

    // By row.
    const std::vector<double> &w() const { return m_w; }

private:
    dxBodyVectors m_bodies;  // forces, then accelerations
    std::vector<double> m_w;
};
