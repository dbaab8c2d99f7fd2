// Where the rows of a triangle lie: what the solves are made for.
#pragma once

#include <ode/common.h>

#include <cstddef>

// One after the other, `skip` elements apart.
class dxRowsApart {
public:
    dxRowsApart(const dReal *first, std::size_t skip) : m_first(first), m_skip(skip) {}
    const dReal *operator()(std::size_t row) const { return m_first + row * m_skip; }

private:
    const dReal *const m_first;
    const std::size_t m_skip;
};

// Anywhere. A row that is taken out of a list leaves the others where they are.
class dxListedRows {
public:
    explicit dxListedRows(const dReal *const *rows) : m_rows(rows) {}
    const dReal *operator()(std::size_t row) const { return m_rows[row]; }

private:
    const dReal *const *const m_rows;
};
