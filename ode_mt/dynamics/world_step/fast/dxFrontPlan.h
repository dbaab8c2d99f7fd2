// How a sparse symmetric matrix in blocks of joints is factorised by fronts (multifrontal method): which joints are eliminated together, and
// where the numbers of their dense matrices are.
//
// A front is a dense matrix: the rows of joints that are eliminated in it (pivots), the rows of later joints that these are coupled with, and
// the right-hand side as the last row. Joints of one front follow one another in the elimination order, and have the same rows below the last
// one (a fundamental supernode). What is left of a front when its pivots are eliminated is its update: a part of the matrix of its parent, the
// front of the first joint below. A front adds up its own blocks of the matrix and its children's updates.
//
// Sources: Duff and Reid, "The multifrontal solution of indefinite sparse symmetric linear equations", ACM Transactions on Mathematical
// Software 9, 1983; Liu, "The multifrontal method for sparse matrix solution: theory and practice", SIAM Review 34, 1992.
//
// Tried and dropped, on a net of 100 by 100 balls on ball joints: nested dissection (9.6 million products of blocks; minimum mean fill 9.4
// million); longer fronts with up to a tenth, or two fifths, of zeros (the same time, or more).
//
// Threading: fronts of the chunks of a dxFactorPlan are factorised side by side, then those at the top. The plan depends on the elimination
// order and the joints' rows alone.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/world_step/fast/dxBlockFactor.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

class dxFrontPlan {
public:
    static constexpr unsigned kLine = 8;  // numbers

    struct Front {
        unsigned begin, end;                    // joints that are eliminated, by place
        unsigned pivots = 0, rows = 0;          // numbers of scalar rows: of these joints, and of those below
        unsigned firstRow = 0, endRow = 0;      // of rowJoints()
        unsigned firstChild = 0, endChild = 0;  // of children()
        std::size_t panel = 0;                  // first number of its panel, the columns of its pivots
        std::size_t madeAt = 0, update = 0;     // first number of its update, when it is made, and later

        // Numbers of a column of the panel: the front's rows and the right-hand side, padded to lines. Those of an update begin with the line
        // in which the first row below the pivots is.
        unsigned panelStride() const { return (pivots + rows + kLine) / kLine * kLine; }
        unsigned firstUpdateLine() const { return pivots / kLine * kLine; }
        unsigned updateStride() const { return panelStride() - firstUpdateLine(); }
        std::size_t panelSize() const { return std::size_t(panelStride()) * pivots; }
        std::size_t updateSize() const { return std::size_t(updateStride()) * rows; }
    };

    // Rows of a child's update that follow one another in its parent's front, too. The last one is the right-hand side.
    struct Run {
        unsigned from, to, length;
    };
    struct Child {
        unsigned front;
        unsigned firstRun, endRun;
    };

    // `rowsOf`: of a joint, by place.
    void make(const dxEliminationOrder &order, const std::vector<unsigned> &rowsOf);

    // Children before their parents.
    const std::vector<Front> &fronts() const { return m_fronts; }
    const std::vector<Child> &children() const { return m_children; }
    const std::vector<Run> &runs() const { return m_runs; }

    // Joints below fronts, ascending.
    const std::vector<unsigned> &rowJoints() const { return m_rowJoints; }

    // Ranges of fronts that are whole subtrees, and fronts above them, ascending.
    struct Chunk {
        unsigned begin, end;
    };
    const std::vector<Chunk> &chunks() const { return m_chunks; }
    const std::vector<unsigned> &top() const { return m_top; }

    unsigned pivots() const { return m_firstPivot.back(); }                      // scalar rows of all joints
    unsigned firstPivotOf(unsigned joint) const { return m_firstPivot[joint]; }  // of a joint, or the end of the last one's

    // The scalar row of a front where those of its `index`-th joint begin: of those that are eliminated, then those below.
    unsigned rowOf(const Front &front, unsigned index) const {
        const unsigned own = front.end - front.begin;
        return index < own ? m_firstPivot[front.begin + index] - m_firstPivot[front.begin]
                           : front.pivots + m_rowPlaces[front.firstRow + index - own];
    }

    std::size_t panelSize() const { return m_panelSize; }
    std::size_t updateSize() const { return m_updateSize; }
    unsigned mostRows() const { return m_mostRows; }  // scalar rows of the largest front, b left out

private:
    void cutTree(const dxEliminationOrder &order);
    void makeFronts(const dxEliminationOrder &order);
    void placeRows(const dxEliminationOrder &order);
    void listChildren();
    void listRuns();
    void listRuns(const Front &parent, const Front &child);
    void placeUpdates();
    unsigned parentOf(const Front &front) const;

    dxFactorPlan m_factorPlan;
    std::vector<unsigned> m_firstPivot;  // and the end of the last one's
    std::vector<unsigned> m_frontOf;     // by joint
    std::vector<unsigned> m_regionOf;    // by joint: its chunk; the number of chunks: the top
    std::vector<Front> m_fronts;
    std::vector<Child> m_children;
    std::vector<Run> m_runs;
    std::vector<unsigned> m_rowJoints, m_rowPlaces;  // the latter: of these joints, the first scalar row among those below
    std::vector<Chunk> m_chunks;
    std::vector<unsigned> m_top;
    std::size_t m_panelSize = 0, m_updateSize = 0;
    unsigned m_mostRows = 0;
};
