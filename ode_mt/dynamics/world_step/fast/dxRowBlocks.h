// An island's A = J inv(M) J' + cfm/h in blocks of joints, its rows without limits apart from those with limits:
//
//   | A_uu  A_ul  b_u |     u  rows without limits, joint by joint in the order of their elimination
//   |       A_ll  b_l |     l  rows with limits, in the order of the island's rows
//
// A_uu is sparse: a block for each two joints that share a body or come to (dxEliminationOrder, whose bodies are joints here). A_ul and
// b_u are one matrix, stored by rows of lines of kBodyLanes columns, of which only those in a mask are not 0; A_ll and b_l are another, the
// right-hand side being its last row. Both have a line more than they need: products are added by whole lines that begin anywhere.
//
// Invariants: a block's lanes and columns beyond its joints' rows are 0. All numbers are doubles, whatever dReal is.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

// The rows of one joint that are without limits, or those that have them.
struct dxRowPart {
    unsigned bodies[2];  // tags; kNoIndex: none
    unsigned firstRow;   // of the island
    unsigned rows;
    bool isLimited;
    unsigned place;  // without limits: in the elimination order; with limits: the first of its rows among those
};

struct dxRowBlocks {
    static constexpr unsigned kMaxLines = 64;  // bits of a mask

    std::vector<dxRowPart> parts;
    dxEliminationOrder order;

    // --- by part and side: column = element, lane = row -----------------------------------------------------
    dxBodyBlocks jacobian;
    dxBodyBlocks byMass;  // J inv(M)

    // Part-sides on the same body, 2 * part + side, the later part first; each with itself, too.
    std::vector<std::pair<unsigned, unsigned>> pairs;

    // --- A_uu: column = row of the earlier joint, lane = row of the later one --------------------------------
    std::vector<unsigned> sizes;  // rows, by place
    dxBodyBlocks diagonal, below;
    std::vector<double> inversePivots;  // kBodyAxes by place
    std::vector<unsigned> slotOf;       // of a joint in the block row under way

    // --- A_ul and A_ll -----------------------------------------------------------------------------------
    unsigned limited = 0;                // rows with limits; column and row of b
    unsigned lines = 1;                  // of a row
    dxBodyVectors beside;                // by place kBodyAxes rows of so many lines
    std::vector<std::uint64_t> masks;    // by place: lines that are not 0
    dxBodyVectors limitedRows;           // limited + 1 rows of so many lines, up to the diagonal's

    dxBodyVector *besideOf(unsigned place, unsigned row) { return beside.data() + (std::size_t(place) * kBodyAxes + row) * lines; }
    const dxBodyVector *besideOf(unsigned place, unsigned row) const {
        return beside.data() + (std::size_t(place) * kBodyAxes + row) * lines;
    }
    dxBodyVector *limitedRow(unsigned row) { return limitedRows.data() + std::size_t(row) * lines; }
    const dxBodyVector *limitedRow(unsigned row) const { return limitedRows.data() + std::size_t(row) * lines; }
};

// Elements of a row of lines.
inline double &dxElement(dxBodyVector *line, unsigned column) { return line[column / kBodyLanes].lane[column % kBodyLanes]; }
inline double dxElement(const dxBodyVector *line, unsigned column) { return line[column / kBodyLanes].lane[column % kBodyLanes]; }
