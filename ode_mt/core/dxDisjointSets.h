// Union-find: which of n elements belong together. Source: Tarjan, "Efficiency of a good but not linear set
// union algorithm", JACM 22(2), 1975; path halving instead of compression, so there is no recursion.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

class dxDisjointSets {
public:
    void reset(std::size_t elements) {
        m_parent.resize(elements);
        std::iota(m_parent.begin(), m_parent.end(), 0u);
    }

    std::uint32_t find(std::uint32_t i) {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }

    // The lower root remains: the result depends on the sets, not on the order of calls.
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a < b) m_parent[b] = a;
        if (b < a) m_parent[a] = b;
    }

private:
    std::vector<std::uint32_t> m_parent;
};
