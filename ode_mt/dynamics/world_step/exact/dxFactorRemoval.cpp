#include "dynamics/world_step/exact/dxFactorRemoval.h"

#include <ode/odemath.h>

#include <algorithm>
#include <cmath>

#include "dynamics/world_step/exact/dxUpstreamLcp.h"

namespace {

// How many products upstream's dot product adds up at a time.
constexpr std::size_t kDotGroup = 4;

// Upstream goes column by column down the rows, which is a cache line for each element. By row, a row needs of the
// columns before it what the update of their own rows has left.
struct Column {
    dReal k1, k2, gamma1, gamma2;
};

// The update is of rank two: L D L' + w1 w1' - w2 w2'.
struct Weights {
    dReal w1, w2;
};

class Update {
public:
    // `columns`: one for each row from task.r on; `a`: of these rows (dxLDLTAddTL).
    Update(const dxFactorRemovalTask &task, const dReal *a, Column *columns)
        : m_task(task), m_a(a), m_columns(columns) {
        m_w11 = static_cast<dReal>((REAL(0.5) * a[0] + 1) * M_SQRT1_2);
        m_w21 = static_cast<dReal>((REAL(0.5) * a[0] - 1) * M_SQRT1_2);
        dReal dee = task.d[task.r];
        const dReal gamma1 = passPivot({m_w11, m_w21}, dee).gamma1;
        m_k1 = REAL(1.0) - m_w21 * gamma1;
        m_k2 = m_w21 * gamma1 * m_w11 - m_w21;
    }

    // Rows first..first+Rows-1, all after r; those before them are done.
    template <unsigned Rows>
    void takeRows(unsigned first) {
        const unsigned before = first - m_task.r;  // columns of the update that all of them have
        Weights weights[Rows];
        dReal *rows[Rows];
        for (unsigned i = 0; i < Rows; ++i) {
            rows[i] = m_task.L[first + i] + m_task.r;
            weights[i] = firstWeights(m_a[before + i], rows[i][0]);
        }
        for (unsigned j = 1; j < before; ++j)
            for (unsigned i = 0; i < Rows; ++i) takeElement(rows[i], j, weights[i]);
        for (unsigned i = 0; i < Rows; ++i) {
            for (unsigned j = before; j < before + i; ++j) takeElement(rows[i], j, weights[i]);
            finishColumn(first + i, weights[i]);
        }
    }

private:
    Weights firstWeights(dReal a, dReal element) const {
        const dReal w = static_cast<dReal>(a * M_SQRT1_2);
        return {w - m_w11 * element, m_k1 * w + m_k2 * element};
    }

    // Its new place is a column before.
    void takeElement(dReal *row, unsigned j, Weights &weights) const {
        const Column &column = m_columns[j];
        dReal element = row[j];
        weights.w1 -= column.k1 * element;
        element += column.gamma1 * weights.w1;
        weights.w2 -= column.k2 * element;
        element -= column.gamma2 * weights.w2;
        row[j - 1] = element;
    }

    // Those of the row's own column, and its pivot.
    void finishColumn(unsigned index, const Weights &weights) {
        dReal dee = m_task.d[index];
        m_columns[index - m_task.r] = passPivot(weights, dee);
        m_task.d[index - 1] = dee;
    }

    // `dee`: the pivot, which becomes another one. Returns what the rows after it need.
    Column passPivot(const Weights &weights, dReal &dee) {
        const dReal k1 = weights.w1, k2 = weights.w2;
        dReal alpha = m_alpha1 + (k1 * k1) * dee;
        dee /= alpha;
        const dReal gamma1 = k1 * dee;
        dee *= m_alpha1;
        m_alpha1 = alpha;
        alpha = m_alpha2 - (k2 * k2) * dee;
        dee /= alpha;
        const dReal gamma2 = k2 * dee;
        dee *= m_alpha2;
        m_alpha2 = alpha;
        return {k1, k2, gamma1, gamma2};
    }

    const dxFactorRemovalTask &m_task;
    const dReal *const m_a;
    Column *const m_columns;
    dReal m_w11, m_w21, m_k1, m_k2, m_alpha1 = 1, m_alpha2 = 1;
};

// Row r of L D.
void findScaledRow(const dxFactorRemovalTask &task, dReal *scaled) {
    const dReal *const row = task.L[task.r];
    for (unsigned i = 0; i < task.r; ++i) scaled[i] = row[i] / task.d[i];
}

// Of what is left of the matrix at r and below, when the rows before r are taken out of it, and what is to be there.
void findDifferences(const dxFactorRemovalTask &task, const dReal *scaled, dReal *a) {
    const auto begin = static_cast<unsigned>(task.r > 0 ? task.skyline.begin(task.r, 1, kDotGroup) : 0);
    for (unsigned i = task.r; i < task.count; ++i) {
        const dReal element = task.column[task.index[i]];
        const dReal *const row = task.L[i];
        a[i - task.r] = task.r > 0 ? dxDot(row + begin, scaled + begin, task.r - begin) - element : -element;
    }
    a[0] += REAL(1.0);
}

}  // namespace

std::size_t dxFactorRemovalStorage(unsigned count) {
    return (2 + sizeof(Column) / sizeof(dReal)) * std::size_t(count);
}

void dxRemoveFactorRow(const dxFactorRemovalTask &task) {
    if (task.r + 1 == task.count) return;
    dReal *const scaled = task.storage, *const a = scaled + task.count;
    findScaledRow(task, scaled);
    findDifferences(task, scaled, a);
    Update update(task, a, reinterpret_cast<Column *>(a + task.count));
    unsigned row = task.r + 1;
    for (; row + 4 <= task.count; row += 4) update.takeRows<4>(row);
    for (; row < task.count; ++row) update.takeRows<1>(row);
    std::rotate(task.L + task.r, task.L + task.r + 1, task.L + task.count);
}
