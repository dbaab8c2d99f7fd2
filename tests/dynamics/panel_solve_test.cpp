// Triangular solves on several workers, of a panel and of one right-hand side, give the bits of those on one, for every instruction set of this
// machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "aligned_numbers.h"
#include "dynamics/world_step/kernels/dxPanelSolve.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "instruction_sets.h"
#include "core/dxCacheLine.h"
#include "../threading/manager_runner.h"

namespace {

// Rows in any place, of which those from the skyline on have elements; what must not be read is no number.
class Triangle {
public:
    Triangle(unsigned rows, bool hasSkyline, unsigned seed) : m_random(seed), m_begins(rows) {
        std::vector<unsigned> places(rows);
        std::iota(places.begin(), places.end(), 0u);
        std::shuffle(places.begin(), places.end(), m_random);
        m_elements.assign(std::size_t(rows) * rows, std::numeric_limits<dReal>::quiet_NaN());
        for (unsigned row = 0; row < rows; ++row) {
            dReal *const own = &m_elements[std::size_t(places[row]) * rows];
            m_begins[row] = hasSkyline ? m_random() % (row + 1) : 0;
            for (unsigned column = 0; column < row; ++column) own[column] = column < m_begins[row] ? 0 : number();
            m_rows.push_back(own);
        }
    }

    const dReal *const *rows() const { return m_rows.data(); }
    dxSkyline skyline() const { return dxSkyline(m_begins.data()); }
    unsigned count() const { return static_cast<unsigned>(m_rows.size()); }
    dReal number() { return std::uniform_real_distribution<dReal>(-0.3, 0.3)(m_random); }

private:
    std::mt19937 m_random;
    std::vector<dReal> m_elements;
    std::vector<const dReal *> m_rows;
    std::vector<unsigned> m_begins;
};

constexpr unsigned kSizes[] = {36, 63, 64, 65, 67, 128, 190, 257, 399};

template <class Check>
void forTriangles(Check check) {
    for (const std::int64_t set : instructionSets())
        onInstructionSet(set, [&] {
            for (const unsigned rows : kSizes)
                for (const bool hasSkyline : {false, true}) {
                    Triangle triangle(rows, hasSkyline, rows);
                    check(triangle);
                    if (testing::Test::HasFatalFailure()) FAIL() << rows << " rows";
                }
        });
}

}  // namespace

TEST(PanelSolve, BackSubstitutionIsThatOfOneThread) {
    ManagerRunner workers(3);
    forTriangles([&](Triangle &triangle) {
        std::vector<dReal> alone(triangle.count());
        for (dReal &value : alone) value = triangle.number();
        for (const dxSkyline &skyline : {dxSkyline(), triangle.skyline()}) {
            std::vector<dReal> expected = alone, shared = alone;
            dxSolveL1Transposed(triangle.rows(), expected.data(), triangle.count(), skyline);
            dxSolveL1Transposed(triangle.rows(), shared.data(), triangle.count(), skyline, &workers);
            ASSERT_EQ(std::memcmp(expected.data(), shared.data(), expected.size() * sizeof(dReal)), 0);
        }
    });
    EXPECT_GT(workers.blocksOfOthers(), 10u);
}

// The first row to solve for is any row before which all are solved.
TEST(PanelSolve, IsThatOfOneThread) {
    ManagerRunner workers(3);
    forTriangles([&](Triangle &triangle) {
        const unsigned rows = triangle.count(), end = rows / 4 * 4;
        AlignedNumbers rightHandSides(std::size_t(rows) * kLineLanes), expected(std::size_t(end) * kLineLanes);
        for (dReal &value : rightHandSides) value = triangle.number();
        std::vector<unsigned> index(rows);
        std::iota(index.begin(), index.end(), 0u);
        for (const dxSkyline &skyline : {dxSkyline(), triangle.skyline()}) {
            dxSolvePanelTask task{triangle.rows(), rightHandSides.data(), kLineLanes, index.data(), skyline, 0, 0, end,
                                  expected.data()};
            dxSolvePanel(task);
            for (const unsigned begin : {0u, 4u, 20u, end / 8 * 4}) {
                AlignedNumbers shared(expected);
                std::fill(shared.begin() + begin * kLineLanes, shared.end(), dReal(7));
                task.begin = begin;
                task.solutions = shared.data();
                dxSolvePanel(task, &workers);
                ASSERT_EQ(std::memcmp(expected.data(), shared.data(), expected.size() * sizeof(dReal)), 0) << begin;
            }
            task.begin = 0;
            task.solutions = expected.data();
        }
    });
    EXPECT_GT(workers.blocksOfOthers(), 10u);
}
