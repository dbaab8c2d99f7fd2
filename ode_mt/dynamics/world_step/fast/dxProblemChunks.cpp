#include "dynamics/world_step/fast/dxProblemChunks.h"

namespace {

// A microsecond of work or so.
constexpr unsigned kRowsPerChunk = 256;

// A body's own work, in rows.
constexpr unsigned kRowsPerBody = 8;

}  // namespace

void dxProblemChunks::make(const dxDirectProblem &problem) {
    listSides(problem);
    cutRows(problem);
    cutBodies(problem);
}

void dxProblemChunks::listSides(const dxDirectProblem &problem) {
    m_firstSide.assign(problem.bodyCount + 1, 0);
    for (const dxManifold &manifold : problem.manifolds)
        for (const unsigned body : manifold.body)
            if (body != dxManifold::kNoBody) ++m_firstSide[body + 1];
    for (unsigned body = 0; body < problem.bodyCount; ++body) m_firstSide[body + 1] += m_firstSide[body];
    m_next.assign(m_firstSide.begin(), m_firstSide.end());
    m_sides.resize(m_firstSide[problem.bodyCount]);
    for (unsigned manifold = 0; manifold < problem.manifolds.size(); ++manifold)
        for (unsigned side = 0; side < 2; ++side) {
            const unsigned body = problem.manifolds[manifold].body[side];
            if (body != dxManifold::kNoBody) m_sides[m_next[body]++] = {manifold, side};
        }
}

void dxProblemChunks::cutRows(const dxDirectProblem &problem) {
    m_rows.clear();
    const unsigned count = padded(problem.rowCount);
    unsigned manifold = 0;
    for (unsigned begin = 0; begin < count; begin += kRowsPerChunk) {
        while (manifold < problem.manifolds.size() && problem.manifolds[manifold].endRow <= begin) ++manifold;
        m_rows.push_back({begin, std::min(begin + kRowsPerChunk, count), manifold});
    }
}

void dxProblemChunks::cutBodies(const dxDirectProblem &problem) {
    m_bodies.clear();
    unsigned rows = kRowsPerChunk;
    for (unsigned body = 0; body < problem.bodyCount; ++body) {
        if (rows >= kRowsPerChunk) {
            m_bodies.push_back({body, body});
            rows = 0;
        }
        rows += kRowsPerBody;
        for (unsigned i = m_firstSide[body]; i < m_firstSide[body + 1]; ++i) {
            const dxManifold &manifold = problem.manifolds[m_sides[i].manifold];
            rows += manifold.endRow - manifold.firstRow;
        }
        m_bodies.back().end = body + 1;
    }
}
