// A triangle is mirrored element by element, for every instruction set of this machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "aligned_numbers.h"
#include "core/dxCacheLine.h"
#include "dynamics/world_step/kernels/dxMirror.h"
#include "instruction_sets.h"

namespace {

// Rows from `first` on hold their lower triangle; everything else is no number.
class Triangle {
public:
    Triangle(std::size_t n, std::size_t first)
        : m_n(n), m_first(first), m_skip((n + kLineLanes - 1) / kLineLanes * kLineLanes),
          m_storage(m_skip * m_skip, std::numeric_limits<dReal>::quiet_NaN()) {
        for (std::size_t i = first; i < n; ++i)
            for (std::size_t j = 0; j <= i; ++j) at(i, j) = lower(i, j);
    }

    dReal &at(std::size_t i, std::size_t j) { return m_storage[i * m_skip + j]; }
    static dReal lower(std::size_t i, std::size_t j) { return dReal(1 + 1000 * i + j); }

    // In two parts, if there are two lines.
    void mirror() {
        const std::size_t begin = m_first / kLineLanes * kLineLanes, middle = std::min(m_n, begin + kLineLanes);
        dxMirrorLower({m_storage.data(), m_skip, m_n, m_first, begin, middle});
        dxMirrorLower({m_storage.data(), m_skip, m_n, m_first, middle, m_n});
    }

    void expectMirrored() {
        for (std::size_t i = m_first; i < m_n; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                ASSERT_EQ(at(i, j), lower(i, j)) << i << ' ' << j;
                ASSERT_EQ(at(j, i), lower(i, j)) << i << ' ' << j;
            }
        for (std::size_t j = 0; j < m_n; ++j) {
            for (std::size_t none = m_n; none < m_skip; ++none) ASSERT_EQ(at(j, none), 0) << j << ' ' << none;
            for (std::size_t none = m_first / kLineLanes * kLineLanes; j < m_first && none < m_first; ++none)
                ASSERT_EQ(at(j, none), 0) << j << ' ' << none;
        }
    }

private:
    const std::size_t m_n, m_first, m_skip;
    AlignedNumbers m_storage;
};

}  // namespace

TEST(Mirror, EveryElementAndZerosBeside) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [] {
            for (std::size_t n = 1; n <= 50; ++n)
                for (std::size_t first = 0; first < n; ++first) {
                    Triangle triangle(n, first);
                    triangle.mirror();
                    triangle.expectMirrored();
                    if (testing::Test::HasFatalFailure()) FAIL() << n << " rows, from " << first << " on";
                }
        });
}
