#include "dynamics/lcp/dxSparseRows.h"

#include <algorithm>

#include "dynamics/lcp/dxLcpArrays.h"

namespace {

// One element in so many, at most: then the groups take less than a third of the matrix's memory.
constexpr std::size_t kSparsity = 16;

std::size_t mostElements(std::size_t n) { return n * n / kSparsity; }

}  // namespace

std::size_t dxSparseRows::memory(unsigned n) {
    return dxArrayBytes<unsigned>(n + std::size_t(1)) + 2 * dxArrayBytes<unsigned>(n) +
           2 * dxArrayBytes<unsigned>(mostElements(n)) + dxArrayBytes<Group>(mostElements(n));
}

void dxSparseRows::build(dxWorldProcessMemArena *arena) {
    m_begins = dxTakeArray<unsigned>(arena, m_n + std::size_t(1));
    count();
    if (m_begins[m_n] > mostElements(m_n)) return;
    m_groupCounts = dxTakeArray<unsigned>(arena, m_n);
    m_patternEnds = dxTakeArray<unsigned>(arena, m_n);
    m_pattern = dxTakeArray<unsigned>(arena, mostElements(m_n));
    m_groupNumbers = dxTakeArray<unsigned>(arena, mostElements(m_n));
    m_groups = dxTakeArray<Group>(arena, mostElements(m_n));
    fillPattern();
    std::fill_n(m_groupCounts, m_n, 0u);
    for (unsigned position = 0; position < m_sets.countC(); ++position)
        insertColumn(m_sets.indexAt(position), position);
}

// The matrix is symmetric: a row has as many elements as its column. Of the first rows only those are counted that
// their columns have in the others.
void dxSparseRows::count() {
    std::fill_n(m_begins, m_n + std::size_t(1), 0u);
    for (unsigned row = m_first; row < m_n; ++row) {
        const dReal *elements = m_A.row(row);
        unsigned count = 0;
        for (unsigned column = 0; column < m_n; ++column) count += elements[column] != 0;
        m_begins[row + 1] = count;
        for (unsigned column = 0; column < m_first; ++column) m_begins[column + 1] += elements[column] != 0;
    }
    for (unsigned row = 0; row < m_n; ++row) m_begins[row + 1] += m_begins[row];
}

void dxSparseRows::fillPattern() {
    std::copy_n(m_begins, m_n, m_patternEnds);
    for (unsigned row = m_first; row < m_n; ++row) {
        const dReal *elements = m_A.row(row);
        for (unsigned column = 0; column < m_n; ++column)
            if (elements[column] != 0) m_pattern[m_patternEnds[column]++] = row;
    }
}

dReal dxSparseRows::multiply(unsigned row, const dReal *factors) const {
    const unsigned wholeGroups = m_sets.countC() / 4, rest = m_sets.countC() % 4;
    const unsigned *numbers = m_groupNumbers + m_begins[row];
    const Group *groups = m_groups + m_begins[row];
    unsigned count = m_groupCounts[row];
    const bool hasRest = count > 0 && numbers[count - 1] == wholeGroups;
    if (hasRest) --count;
    dReal sum = 0;
    for (unsigned k = 0; k < count; ++k) {
        const dReal *a = groups[k].elements, *x = factors + std::size_t(numbers[k]) * 4;
        sum += a[0] * x[0] + a[1] * x[1] + a[2] * x[2] + a[3] * x[3];
    }
    for (unsigned k = 0; hasRest && k < rest; ++k)
        sum += groups[count].elements[k] * factors[std::size_t(wholeGroups) * 4 + k];
    return sum;
}

void dxSparseRows::append(unsigned column) {
    if (isBuilt()) insertColumn(column, m_sets.countC() - 1);
}

void dxSparseRows::remove(unsigned position) {
    if (!isBuilt()) return;
    const unsigned lastPosition = m_sets.countC() - 1, last = m_sets.indexAt(lastPosition);
    eraseColumn(m_sets.indexAt(position), position);
    if (position == lastPosition) return;
    eraseColumn(last, lastPosition);
    insertColumn(last, position);
}

void dxSparseRows::insertColumn(unsigned column, unsigned position) {
    for (unsigned k = m_begins[column]; k < m_patternEnds[column]; ++k)
        insert(m_pattern[k], position, m_A.row(m_pattern[k])[column]);
}

void dxSparseRows::eraseColumn(unsigned column, unsigned position) {
    for (unsigned k = m_begins[column]; k < m_patternEnds[column]; ++k) erase(m_pattern[k], position);
}

// The first of a row's groups that is not before the given one. Most searches are for the last.
unsigned dxSparseRows::findGroup(unsigned row, unsigned group) const {
    const unsigned *numbers = m_groupNumbers + m_begins[row];
    unsigned k = m_groupCounts[row];
    while (k > 0 && numbers[k - 1] >= group) --k;
    return k;
}

void dxSparseRows::insert(unsigned row, unsigned position, dReal element) {
    unsigned *numbers = m_groupNumbers + m_begins[row];
    Group *groups = m_groups + m_begins[row];
    const unsigned group = position / 4, k = findGroup(row, group), count = m_groupCounts[row];
    if (k == count || numbers[k] != group) {
        std::copy_backward(numbers + k, numbers + count, numbers + count + 1);
        std::copy_backward(groups + k, groups + count, groups + count + 1);
        numbers[k] = group;
        groups[k] = Group();
        ++m_groupCounts[row];
    }
    groups[k].elements[position % 4] = element;
}

void dxSparseRows::erase(unsigned row, unsigned position) {
    unsigned *numbers = m_groupNumbers + m_begins[row];
    Group *groups = m_groups + m_begins[row];
    const unsigned k = findGroup(row, position / 4), count = m_groupCounts[row];
    groups[k].elements[position % 4] = 0;
    const dReal *elements = groups[k].elements;
    if (elements[0] != 0 || elements[1] != 0 || elements[2] != 0 || elements[3] != 0) return;
    std::copy(numbers + k + 1, numbers + count, numbers + k);
    std::copy(groups + k + 1, groups + count, groups + k);
    --m_groupCounts[row];
}
