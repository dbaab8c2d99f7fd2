// A greedy colouring of edges between bodies: those of one colour share no moving body.
//
// Source of the method: Saad, "Iterative Methods for Sparse Linear Systems", 12.4 (multicolour orderings).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/dxReserve.h"
#include "dynamics/quick_step/fast/dxContactManifold.h"

class dxEdgeColors {
public:
    static constexpr unsigned kMost = 63, kLeftOver = kMost;

    // `moves`: by body; it has to remain. Throws std::bad_alloc.
    void begin(const std::vector<std::uint8_t> &moves) {
        m_moves = &moves;
        dxFill(m_used, moves.size(), 0);
        m_count = 0;
    }
    void reserveAs(const dxEdgeColors &other) { m_used.reserve(other.m_used.capacity()); }

    // The first colour that is free on both bodies; kLeftOver where none is.
    unsigned take(const int (&body)[2]) {
        std::uint64_t used = 0;
        for (const int end : body)
            if (moves(end)) used |= m_used[static_cast<unsigned>(end)];
        const auto color = static_cast<unsigned>(__builtin_ctzll(~used | std::uint64_t(1) << kLeftOver));
        if (color == kLeftOver) return color;
        m_count = std::max(m_count, color + 1);
        for (const int end : body)
            if (moves(end)) m_used[static_cast<unsigned>(end)] |= std::uint64_t(1) << color;
        return color;
    }

    unsigned count() const { return m_count; }

private:
    bool moves(int body) const { return dxDoesMove(body, *m_moves); }

    const std::vector<std::uint8_t> *m_moves = nullptr;
    std::vector<std::uint64_t> m_used;  // by body: a bit for each colour
    unsigned m_count = 0;
};
