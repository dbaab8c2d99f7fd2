// How the loops over an island's rows and bodies are shared: chunks of both, with what a chunk of bodies reads of rows. They depend on the
// problem alone.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxDirectProblem.h"

class dxProblemChunks {
public:
    // One side of a manifold.
    struct Side {
        unsigned manifold, side;
    };

    struct Rows {
        unsigned begin, end;    // multiples of kBodyLanes, the last end too
        unsigned firstManifold;  // that has a row here
    };

    struct Bodies {
        unsigned begin, end;
    };

    void make(const dxDirectProblem &problem);

    const std::vector<Rows> &rows() const { return m_rows; }
    const std::vector<Bodies> &bodies() const { return m_bodies; }

    // Of a body: firstSide(body) to firstSide(body + 1), manifolds ascending.
    unsigned firstSide(unsigned body) const { return m_firstSide[body]; }
    const Side &side(unsigned index) const { return m_sides[index]; }

    // With as many rows as vectors of any length read: those beyond the problem's are fixed at 0.
    static unsigned padded(unsigned rows) { return (rows + kBodyLanes - 1) / kBodyLanes * kBodyLanes; }

private:
    void listSides(const dxDirectProblem &problem);
    void cutRows(const dxDirectProblem &problem);
    void cutBodies(const dxDirectProblem &problem);

    std::vector<unsigned> m_firstSide, m_next;
    std::vector<Side> m_sides;
    std::vector<Rows> m_rows;
    std::vector<Bodies> m_bodies;
};
