// The kernels over packs of joints, on every instruction set: impulses that are swept long enough solve the rows' conditions, velocities are those
// that the impulses give, and the bits do not depend on the width of vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "dynamics/quick_step/fast/dxJointSweep.h"
#include "instruction_sets.h"

namespace {

constexpr double kRounding = 1e-5;  // of floats whose size is about 1

// Packs of joints, each between two bodies of its own, or one and the static environment. In the first pack lane 7 is empty, and lane 6 has one row
// less than the others.
class Packs {
public:
    static constexpr unsigned kPacks = 2, kBodies = 2 * kPacks * dxLanes::kCount, kRows = 5;

    explicit Packs(unsigned seed)
        : m_random(seed), m_velocities(kBodies + 1), m_masses(kBodies), m_energies(kPacks), m_packs(kPacks), m_rows(kPacks * kRows) {
        for (unsigned i = 0; i < kBodies; ++i) addBody(i);
        m_free = m_velocities;
        for (unsigned i = 0; i < kPacks; ++i) {
            m_packs[i].firstRow = i * kRows;
            m_packs[i].rowCount = kRows;
            for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) fillLane(i, lane);
        }
    }

    double prepare() { return dxPrepareJoints(packs(), 0, kPacks, m_velocities.data()); }
    double apply() { return dxApplyJointImpulses(packs(), 0, kPacks, m_velocities.data()); }
    double sweep(dReal factor = 1) { return dxSweepJoints(packs(), 0, kPacks, factor, m_velocities.data()); }

    // The free velocities and what the impulses add.
    std::vector<dxSpatialMotion> sum() {
        std::vector<dxSpatialMotion> sums = m_free;
        dxAddJointImpulses(packs(), 0, kPacks, m_masses.data(), sums.data());
        return sums;
    }

    // All bodies.
    void speedUp(dReal velocity) {
        for (unsigned body = 0; body < kBodies; ++body) m_velocities[body].columns[0] += velocity;
    }

    const std::vector<dxSpatialMotion> &velocities() const { return m_velocities; }
    double energyOf(unsigned pack, unsigned lane) const { return m_energies[pack].lane[lane]; }
    dxJointLanes &row(unsigned pack, unsigned row) { return m_rows[pack * kRows + row]; }
    bool has(unsigned pack, unsigned lane, unsigned row) const { return pack != 0 || (lane != 7 && (lane != 6 || row + 1 < kRows)); }

    double velocityAlong(unsigned pack, unsigned lane, unsigned row) const {
        double sum = 0;
        for (int side = 0; side < 2; ++side) {
            const dReal *const u = m_velocities[static_cast<std::size_t>(m_packs[pack].source[side][lane])].columns;
            for (int i = 0; i < 6; ++i) sum += jacobian(m_rows[pack * kRows + row], lane, side, i) * u[i];
        }
        return sum;
    }

    std::vector<dxSpatialMotion> expectedVelocities() const {
        std::vector<dxSpatialMotion> all = m_free;
        for (unsigned pack = 0; pack < kPacks; ++pack)
            for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                for (unsigned k = 0; k < kRows; ++k)
                    for (int side = 0; side < 2; ++side) push(all, m_packs[pack].target[side][lane], m_rows[pack * kRows + k], lane, side);
        return all;
    }

private:
    dxJointPacks packs() { return {m_packs.data(), m_rows.data(), m_energies.data()}; }
    double number() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }

    void addBody(unsigned body) {
        for (dReal &column : m_velocities[body].columns) column = number();
        dxIslandBody &masses = m_masses[body];
        masses.invMass = body % 9 != 8 ? static_cast<float>(1 + number() / 2) : 0;
        for (int i = 0; i < 3; ++i)
            for (int k = i; k < 3; ++k)
                masses.invInertia[3 * i + k] = masses.invInertia[3 * k + i] = static_cast<float>(number() / 4 + (i == k ? 2 : 0));
    }

    void fillLane(unsigned pack, unsigned lane) {
        m_packs[pack].clear(lane, kBodies);
        if (!has(pack, lane, 0)) return;
        const int first = static_cast<int>(2 * (pack * dxLanes::kCount + lane)), second = lane != 5 ? first + 1 : dxLaneBodies::kNoBody;
        m_packs[pack].set(lane, {first, second}, m_masses.data());
        for (unsigned k = 0; k < kRows; ++k)
            if (has(pack, lane, k)) fillRow(row(pack, k), lane, k);
    }

    void fillRow(dxJointLanes &row, unsigned lane, unsigned number) {
        for (dxLaneNumbers *const axes : {row.linear, row.angular, row.together})
            for (int axis = 0; axis < 3; ++axis) axes[axis].set(lane, this->number());
        row.bias.set(lane, this->number());
        row.softness.set(lane, dReal(0.05));
        const dReal limit = number == 2 ? dReal(0.1) : dInfinity;
        row.low.set(lane, number == 3 ? 0 : -limit);
        row.high.set(lane, limit);
    }

    static double jacobian(const dxJointLanes &row, unsigned lane, int side, int column) {
        if (column < 3) return (side == 0 ? 1.0 : -1.0) * static_cast<double>(row.linear[column].lane[lane]);
        const auto onA = static_cast<double>(row.angular[column - 3].lane[lane]);
        return side == 0 ? onA : static_cast<double>(row.together[column - 3].lane[lane]) - onA;
    }

    void push(std::vector<dxSpatialMotion> &all, int body, const dxJointLanes &row, unsigned lane, int side) const {
        if (body == dxLaneBodies::kNoBody) return;
        dReal columns[6], change[6];
        for (int i = 0; i < 6; ++i) columns[i] = jacobian(row, lane, side, i) * static_cast<double>(row.impulse.lane[lane]);
        m_masses[static_cast<std::size_t>(body)].respond(columns, change);
        for (int i = 0; i < 6; ++i) all[static_cast<std::size_t>(body)].columns[i] += change[i];
    }

    std::mt19937 m_random;
    std::vector<dxSpatialMotion> m_velocities, m_free;
    std::vector<dxIslandBody> m_masses;
    std::vector<dxLaneNumbers> m_energies;
    std::vector<dxJointPack> m_packs;
    std::vector<dxJointLanes> m_rows;
};

TEST(JointSweep, FindsImpulsesThatSolveTheRows) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Packs packs(seed);
            EXPECT_GT(packs.prepare(), 0);
            double change = 0;
            for (int i = 0; i < 3000; ++i) change = packs.sweep(i % 2 == 0 ? dReal(1) : dReal(1.3));
            EXPECT_LT(change, 1e-8);
            for (unsigned pack = 0; pack < Packs::kPacks; ++pack)
                for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                    for (unsigned k = 0; k < Packs::kRows; ++k) {
                        if (!packs.has(pack, lane, k)) continue;
                        const dxJointLanes &row = packs.row(pack, k);
                        const double impulse = row.impulse.lane[lane], low = row.low.lane[lane], high = row.high.lane[lane];
                        const double missing = row.bias.lane[lane] - packs.velocityAlong(pack, lane, k) - row.softness.lane[lane] * impulse;
                        EXPECT_GE(impulse, low);
                        EXPECT_LE(impulse, high);
                        if (impulse > low) EXPECT_GT(missing, -kRounding);
                        if (impulse < high) EXPECT_LT(missing, kRounding);
                    }
        }
    });
}

TEST(JointSweep, LeavesTheVelocitiesThatTheImpulsesGive) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Packs packs(seed);
            packs.prepare();
            for (int i = 0; i < 5; ++i) packs.sweep(dReal(1.3));
            const std::vector<dxSpatialMotion> expected = packs.expectedVelocities(), sum = packs.sum();
            for (unsigned body = 0; body < Packs::kBodies; ++body)
                for (int k = 0; k < 6; ++k) {
                    EXPECT_NEAR(packs.velocities()[body].columns[k], expected[body].columns[k], kRounding);
                    EXPECT_NEAR(sum[body].columns[k], expected[body].columns[k], 1e-12);
                }
        }
    });
}

// Impulses of the last step become those within the limits. What they add to 1/2 u' M u + 1/2 p' softness p - bias' p is their work on the mean of
// the velocities before and after them, less what is wanted.
TEST(JointSweep, AppliesImpulsesWithinTheLimits) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Packs packs(seed);
            for (unsigned pack = 0; pack < Packs::kPacks; ++pack)
                for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                    for (unsigned k = 0; k < Packs::kRows; ++k)
                        if (packs.has(pack, lane, k)) packs.row(pack, k).impulse.lane[lane] = 0.4f - 0.05f * static_cast<float>(lane);
            packs.prepare();
            std::vector<double> before;
            const auto forRows = [&](const auto &visit) {
                for (unsigned pack = 0; pack < Packs::kPacks; ++pack)
                    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                        for (unsigned k = 0; k < Packs::kRows; ++k) visit(pack, lane, k, packs.row(pack, k));
            };
            forRows([&](unsigned pack, unsigned lane, unsigned k, const dxJointLanes &row) {
                EXPECT_GE(row.impulse.lane[lane], row.low.lane[lane]);
                EXPECT_LE(row.impulse.lane[lane], row.high.lane[lane]);
                before.push_back(packs.velocityAlong(pack, lane, k));
            });
            const double found = packs.apply();
            const std::vector<dxSpatialMotion> expected = packs.expectedVelocities();
            for (unsigned body = 0; body < Packs::kBodies; ++body)
                for (int k = 0; k < 6; ++k) EXPECT_NEAR(packs.velocities()[body].columns[k], expected[body].columns[k], kRounding);
            double sum = 0;
            std::size_t i = 0;
            forRows([&](unsigned pack, unsigned lane, unsigned k, const dxJointLanes &row) {
                const double impulse = row.impulse.lane[lane], mean = (before[i++] + packs.velocityAlong(pack, lane, k)) / 2;
                sum += impulse * (mean - row.bias.lane[lane] + row.softness.lane[lane] * impulse / 2);
            });
            EXPECT_NEAR(found, sum, Packs::kPacks * dxLanes::kCount * kRounding);
        }
    });
}

// The first row alone takes this energy out of the residual; an empty lane has none.
TEST(JointSweep, FindsTheEnergyOfTheChange) {
    onAllInstructionSets([] {
        Packs packs(3);
        packs.prepare();
        std::vector<double> expected(dxLanes::kCount, 0.0);
        for (unsigned k = 1; k < Packs::kRows; ++k)
            for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) packs.row(1, k).low.lane[lane] = packs.row(1, k).high.lane[lane] = 0;
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            const double residual = packs.row(1, 0).bias.lane[lane] - packs.velocityAlong(1, lane, 0);
            expected[lane] = residual * residual * packs.row(1, 0).effectiveMass.lane[lane];
        }
        packs.sweep();
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) EXPECT_NEAR(packs.energyOf(1, lane), expected[lane], kRounding);
        EXPECT_EQ(packs.energyOf(0, 7), 0);
    });
}

// Bodies that move together at 1000 km/s are held as at rest.
TEST(JointSweep, SeesTheDifferenceOfLargeVelocities) {
    onAllInstructionSets([] {
        constexpr dReal kVelocity = 1e6;
        Packs slow(5), fast(5);
        fast.speedUp(kVelocity);
        for (Packs *const packs : {&slow, &fast}) {
            packs->prepare();
            for (int i = 0; i < 5; ++i) packs->sweep();
        }
        for (unsigned lane = 0; lane < 5; ++lane)  // those of two bodies
            for (const unsigned body : {2 * lane, 2 * lane + 1})
                EXPECT_NEAR(fast.velocities()[body].columns[0] - kVelocity, slow.velocities()[body].columns[0], kRounding);
    });
}

TEST(JointSweep, LeavesBodiesAloneThatDoNotMove) {
    onAllInstructionSets([] {
        Packs packs(4), same(4);
        packs.prepare();
        for (int i = 0; i < 5; ++i) packs.sweep();
        for (const unsigned body : {8u, 11u, 14u, 15u, 17u, Packs::kBodies})  // without mass, or of no joint
            EXPECT_TRUE(std::equal(packs.velocities()[body].columns, packs.velocities()[body].columns + 6, same.velocities()[body].columns));
    });
}

TEST(JointSweep, HasTheSameBitsOnEveryInstructionSet) {
    std::vector<double> first;
    onAllInstructionSets([&first] {
        std::vector<double> numbers;
        for (unsigned seed = 0; seed < 20; ++seed) {
            Packs packs(seed);
            numbers.push_back(packs.prepare());
            for (int i = 0; i < 7; ++i) numbers.push_back(packs.sweep(dReal(1.3)));
            for (const dxSpatialMotion &velocity : packs.velocities()) numbers.insert(numbers.end(), velocity.columns, velocity.columns + 6);
        }
        if (first.empty()) first = numbers;
        EXPECT_EQ(numbers, first);
    });
}

}  // namespace
