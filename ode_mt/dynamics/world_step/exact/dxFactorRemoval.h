// Removes a row and a column from an LDLT factorisation: upstream's dxLDLTRemove (ode/src/matrix.cpp), row by row.
//
// Such updates of factorisations are those of Gill, Golub, Murray and Saunders, "Methods for modifying matrix factorizations", 1974.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "dynamics/world_step/kernels/dxTriangle.h"

struct dxFactorRemovalTask {
    dReal **L;  // rows of a lower triangle with ones on its diagonal, which is not read
    dReal *d;   // 1/D
    unsigned count, r;  // number of rows, and the one to be removed
    // The column of the factorised matrix that goes: its element in row i is column[index[i]], for i >= r.
    const dReal *column;
    const unsigned *index;
    dxSkyline skyline;
    dReal *storage;  // dxFactorRemovalStorage(count) elements
};

std::size_t dxFactorRemovalStorage(unsigned count);

// Upstream's bits in the rows before count - 1; skipping the columns before the skyline is exact under the conditions
// named in dxSolveL1.h. Upstream moves all rows after r, and what lies above the diagonal, too; here row r goes to the
// end of the list, and the others stay where they are.
void dxRemoveFactorRow(const dxFactorRemovalTask &task);
