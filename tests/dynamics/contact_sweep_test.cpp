// The kernels over packs of contacts, on every instruction set: impulses that are swept long enough solve the contact's
// conditions, velocities are those that the impulses give, and the bits do not depend on the width of vectors.
//
// Covers dxContactPreparation.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "dynamics/quick_step/fast/dxContactSweep.h"
#include "instruction_sets.h"

namespace {

constexpr double kRounding = 1e-5;  // of floats whose size is about 1

using Vector = std::array<double, 3>;

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// One pack of manifolds, each between two bodies of its own, or one and the static environment. Lane 7 is empty, lane 6 has one contact less than the
// others.
class Pack {
public:
    static constexpr unsigned kBodies = 2 * dxLanes::kCount, kContacts = 3;

    explicit Pack(unsigned seed, bool hasResponses = true)
        : m_random(seed),
          m_hasResponses(hasResponses),
          m_velocities(kBodies + 1),
          m_energies(1),
          m_contacts(kContacts),
          m_responses(kContacts) {
        m_packs.resize(1);
        m_packs[0].contactCount = kContacts;
        for (unsigned i = 0; i < kBodies; ++i)
            for (int k = 0; k < 6; ++k) m_velocities[i].columns[k] = number();
        m_free = m_velocities;
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) fillLane(lane);
    }

    dxContactPacks packs() {
        return {m_packs.data(), m_contacts.data(), m_energies.data(), m_hasResponses ? m_responses.data() : nullptr};
    }
    double prepare() { return dxPrepareContacts(packs(), 0, 1, m_velocities.data()); }
    double apply() { return dxApplyImpulses(packs(), 0, 1, m_velocities.data()); }
    // One of all rows at once, and one of normals first. Returns the energy of the latter.
    double sweep(dReal factor = 1) {
        const auto part = [&](dxSweepPart part) { return dxSweepContacts(packs(), 0, 1, part, {factor, factor}, m_velocities.data()); };
        part(dxSweepPart::AllRows);
        return part(dxSweepPart::Normals) + part(dxSweepPart::EvenFriction) + part(dxSweepPart::OddFriction);
    }

    // The free velocities and what the impulses add, as Sum of dxPgsSolver finds them.
    std::vector<dxSpatialMotion> sum() {
        std::vector<dxIslandBody> masses(kBodies);
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
            for (unsigned side = 0; side < 2; ++side) {
                if (m_packs[0].target[side][lane] == dxContactPack::kNoBody) continue;
                dxIslandBody &body = masses[static_cast<std::size_t>(m_packs[0].target[side][lane])];
                body.invMass = m_packs[0].inverseMass[side].lane[lane];
                for (int i = 0; i < 9; ++i) body.invInertia[i] = m_packs[0].inverseInertia[side][kElement[i / 3][i % 3]].lane[lane];
            }
        std::vector<dxSpatialMotion> sums = m_free;
        dxAddImpulses(packs(), 0, 1, masses.data(), sums.data());
        return sums;
    }

    // Both bodies of the manifolds in the first four lanes.
    void speedUp(double velocity) {
        for (unsigned body = 0; body < 8; ++body) m_velocities[body].columns[0] += velocity;
    }

    const std::vector<dxSpatialMotion> &velocities() const { return m_velocities; }
    dxContactLanes &contact(unsigned i) { return m_contacts[i]; }
    double energyOf(unsigned lane) const { return m_energies[0].lane[lane]; }

    bool has(unsigned lane, unsigned contact) const { return lane != 7 && (lane != 6 || contact + 1 < kContacts); }

    // The velocity along a row, of the pack's velocities or of those that the impulses give.
    double velocityAlong(const std::vector<dxSpatialMotion> &velocities, unsigned lane, unsigned contact, unsigned row) const {
        double sum = 0;
        for (unsigned side = 0; side < 2; ++side) {
            const int body = m_packs[0].source[side][lane];
            const dReal *const u = velocities[static_cast<std::size_t>(body)].columns;
            const Vector v = {u[0], u[1], u[2]}, w = {u[3], u[4], u[5]};
            const Vector direction = vectorOf(m_contacts[contact].direction[row], lane),
                         rA = offsetOf(m_contacts[contact], side, lane);
            sum += (side == 0 ? 1 : -1) * (dot(direction, v) + dot(cross(rA, direction), w));
        }
        return sum;
    }

    // The free velocities and what the impulses add.
    std::vector<dxSpatialMotion> expectedVelocities() const {
        std::vector<dxSpatialMotion> all = m_free;
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
            for (const dxContactLanes &contact : m_contacts)
                for (unsigned row = 0; row < 3; ++row)
                    for (unsigned side = 0; side < 2; ++side) push(all, lane, contact, row, side);
        return all;
    }

private:
    static constexpr int kElement[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};  // of a symmetric matrix: the place of a row's column

    float number() { return std::uniform_real_distribution<float>(-1, 1)(m_random); }

    static Vector vectorOf(const dxLaneNumbers *numbers, unsigned lane) {
        return {numbers[0].lane[lane], numbers[1].lane[lane], numbers[2].lane[lane]};
    }

    Vector offsetOf(const dxContactLanes &contact, unsigned side, unsigned lane) const {
        Vector rA = vectorOf(contact.rA, lane);
        const Vector dAB = vectorOf(m_packs[0].dAB, lane);
        if (side == 1)
            for (std::size_t i = 0; i < 3; ++i) rA[i] += dAB[i];
        return rA;
    }

    void fillLane(unsigned lane) {
        dxContactPack &pack = m_packs[0];
        for (unsigned side = 0; side < 2; ++side) {
            pack.source[side][lane] = kBodies;
            pack.target[side][lane] = dxContactPack::kNoBody;
            if (lane == 7 || (lane == 5 && side == 1)) continue;
            const int body = static_cast<int>(2 * lane + side);
            pack.source[side][lane] = body;
            if (lane == 4 && side == 1) continue;  // moves on its own
            pack.target[side][lane] = body;
            pack.inverseMass[side].lane[lane] = 1 + number() / 2;
            const float inertia[6] = {2 + number() / 2, number() / 4, number() / 4, 2 + number() / 2, number() / 4, 2 + number() / 2};
            for (int i = 0; i < 6; ++i) pack.inverseInertia[side][i].lane[lane] = inertia[i];
        }
        for (auto &dAB : pack.dAB)
            if (lane != 5 && lane != 7) dAB.lane[lane] = number();
        for (unsigned i = 0; i < kContacts; ++i)
            if (has(lane, i)) fillContact(m_contacts[i], lane);
    }

    void fillContact(dxContactLanes &contact, unsigned lane) {
        Vector normal = {number(), number(), number()};
        const double length = std::sqrt(dot(normal, normal));
        for (int axis = 0; axis < 3; ++axis) {
            contact.direction[dxContactLanes::kNormal][axis].lane[lane] = static_cast<float>(normal[static_cast<std::size_t>(axis)] / length);
            contact.rA[axis].lane[lane] = number();
        }
        for (int row = 0; row < 3; ++row) {
            contact.bias[row].lane[lane] = number();
            contact.softness[row].lane[lane] = 0.05f;
        }
        for (int tangent = 0; tangent < 2; ++tangent) {
            contact.friction[tangent].lane[lane] = lane % 2 == 0 ? 0.5f : 0;
            contact.limit[tangent].lane[lane] = lane % 2 == 0 ? 0 : 0.1f;
        }
    }

    void push(std::vector<dxSpatialMotion> &all, unsigned lane, const dxContactLanes &contact, unsigned row, unsigned side) const {
        const dxContactPack &pack = m_packs[0];
        const int target = pack.target[side][lane];
        if (target == dxContactPack::kNoBody) return;
        const double impulse = (side == 0 ? 1 : -1) * contact.impulse[row].lane[lane];
        const Vector direction = vectorOf(contact.direction[row], lane),
                     axis = cross(offsetOf(contact, side, lane), direction);
        for (std::size_t i = 0; i < 3; ++i) {
            all[static_cast<std::size_t>(target)].columns[i] += pack.inverseMass[side].lane[lane] * direction[i] * impulse;
            for (std::size_t k = 0; k < 3; ++k)
                all[static_cast<std::size_t>(target)].columns[3 + i] +=
                    pack.inverseInertia[side][kElement[i][k]].lane[lane] * axis[k] * impulse;
        }
    }

    std::mt19937 m_random;
    bool m_hasResponses;
    std::vector<dxSpatialMotion> m_velocities, m_free;
    std::vector<dxLaneNumbers> m_energies;
    std::vector<dxContactPack> m_packs;
    std::vector<dxContactLanes> m_contacts;
    std::vector<dxContactResponse> m_responses;
};

TEST(ContactSweep, PreparesThreeDirectionsAtRightAngles) {
    onAllInstructionSets([] {
        Pack pack(1);
        pack.prepare();
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
            for (unsigned i = 0; i < Pack::kContacts; ++i) {
                if (!pack.has(lane, i)) continue;
                for (unsigned a = 0; a < 3; ++a)
                    for (unsigned b = 0; b < 3; ++b) {
                        double product = 0;
                        for (int axis = 0; axis < 3; ++axis)
                            product +=
                                pack.contact(i).direction[a][axis].lane[lane] * pack.contact(i).direction[b][axis].lane[lane];
                        EXPECT_NEAR(product, a == b ? 1 : 0, 1e-6);
                    }
            }
    });
}

TEST(ContactSweep, KeepsAGivenDirection) {
    onAllInstructionSets([] {
        Pack pack(2);
        for (int axis = 0; axis < 3; ++axis) pack.contact(0).direction[dxContactLanes::kTangent][axis].lane[3] = 0.25f * static_cast<float>(axis + 1);
        pack.prepare();
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(pack.contact(0).direction[dxContactLanes::kTangent][axis].lane[3], 0.25f * static_cast<float>(axis + 1));
    });
}

TEST(ContactSweep, FindsForcesThatSolveTheConditions) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Pack pack(seed);
            EXPECT_GT(pack.prepare(), 0);
            pack.apply();
            double change = 0;
            for (int i = 0; i < 3000; ++i) change = pack.sweep(i % 2 == 0 ? dReal(1) : dReal(1.3));
            EXPECT_LT(change, 1e-6);  // sliding contacts: the limit of friction changes by roundings of the normal's impulse
            for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                for (unsigned i = 0; i < Pack::kContacts; ++i) {
                    if (!pack.has(lane, i)) continue;
                    const dxContactLanes &contact = pack.contact(i);
                    for (unsigned row = 0; row < 3; ++row) {
                        const double impulse = contact.impulse[row].lane[lane];
                        const double missing = contact.bias[row].lane[lane] -
                                               pack.velocityAlong(pack.velocities(), lane, i, row) -
                                               contact.softness[row].lane[lane] * impulse;
                        const double high = row == 0 ? 1e300
                                                     : contact.friction[row - 1].lane[lane] * contact.impulse[dxContactLanes::kNormal].lane[lane] +
                                                           contact.limit[row - 1].lane[lane];
                        const double low = row == 0 ? 0 : -high;
                        EXPECT_GE(impulse, low - kRounding);
                        EXPECT_LE(impulse, high + kRounding);
                        if (impulse > low + kRounding) EXPECT_GT(missing, -kRounding);
                        if (impulse < high - kRounding) EXPECT_LT(missing, kRounding);
                    }
                }
        }
    });
}

TEST(ContactSweep, LeavesTheVelocitiesThatTheForcesGive) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Pack pack(seed);
            for (unsigned i = 0; i < Pack::kContacts; ++i)  // a force of the last step, in the world's frame
                for (int axis = 0; axis < 3; ++axis) pack.contact(i).impulse[axis].lane[0] = 0.1f * static_cast<float>(axis);
            pack.prepare();
            pack.apply();
            for (int i = 0; i < 5; ++i) pack.sweep();
            const std::vector<dxSpatialMotion> expected = pack.expectedVelocities(), sum = pack.sum();
            for (unsigned body = 0; body < Pack::kBodies; ++body)
                for (int k = 0; k < 6; ++k) {
                    EXPECT_NEAR(pack.velocities()[body].columns[k], expected[body].columns[k], kRounding);
                    EXPECT_NEAR(sum[body].columns[k], expected[body].columns[k], 1e-12);
                }
        }
    });
}

// Two bodies that move together at 1000 km/s push one another apart as at rest.
TEST(ContactSweep, SeesTheDifferenceOfLargeVelocities) {
    onAllInstructionSets([] {
        constexpr double kVelocity = 1e6;
        Pack slow(5), fast(5);
        fast.speedUp(kVelocity);
        for (Pack *const pack : {&slow, &fast}) {
            pack->prepare();
            pack->apply();
            for (int i = 0; i < 5; ++i) pack->sweep();
        }
        for (unsigned body = 0; body < 8; ++body)
            EXPECT_NEAR(fast.velocities()[body].columns[0] - kVelocity, slow.velocities()[body].columns[0], kRounding);
    });
}

// What impulses add to 1/2 u' M u + 1/2 p' softness p - bias' p: their work on the mean of the velocities before and after them, less
// what is wanted.
TEST(ContactSweep, FindsTheEnergyOfAppliedImpulses) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Pack pack(seed);
            for (unsigned i = 0; i < Pack::kContacts; ++i)
                for (int axis = 0; axis < 3; ++axis)
                    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane)
                        if (pack.has(lane, i))
                            pack.contact(i).impulse[axis].lane[lane] = 0.3f * static_cast<float>(axis) - 0.05f * static_cast<float>(lane);
            pack.prepare();
            const std::vector<dxSpatialMotion> before = pack.velocities();
            const double found = pack.apply();
            double sum = 0;
            for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
                double expected = 0;
                for (unsigned i = 0; i < Pack::kContacts; ++i) {
                    if (!pack.has(lane, i)) continue;
                    const dxContactLanes &contact = pack.contact(i);
                    for (unsigned row = 0; row < 3; ++row) {
                        const double impulse = contact.impulse[row].lane[lane];
                        const double mean = (pack.velocityAlong(before, lane, i, row) +
                                             pack.velocityAlong(pack.velocities(), lane, i, row)) / 2;
                        expected += impulse * (mean - contact.bias[row].lane[lane] +
                                               contact.softness[row].lane[lane] * impulse / 2);
                    }
                }
                EXPECT_NEAR(pack.energyOf(lane), expected, kRounding) << "lane " << lane;
                sum += expected;
            }
            EXPECT_NEAR(found, sum, dxLanes::kCount * kRounding);
        }
    });
}

// A manifold's contacts see one another by their responses or by the bodies.
TEST(ContactSweep, FindsTheSameWithoutResponses) {
    onAllInstructionSets([] {
        for (unsigned seed = 0; seed < 20; ++seed) {
            Pack with(seed), without(seed, false);
            for (Pack *const pack : {&with, &without}) {
                pack->prepare();
                pack->apply();
                for (int i = 0; i < 5; ++i) pack->sweep();
            }
            for (unsigned body = 0; body < Pack::kBodies; ++body)
                for (int k = 0; k < 6; ++k)
                    EXPECT_NEAR(with.velocities()[body].columns[k], without.velocities()[body].columns[k], kRounding);
        }
    });
}

TEST(ContactSweep, LeavesBodiesAloneThatDoNotMove) {
    onAllInstructionSets([] {
        Pack pack(4), same(4);
        pack.prepare();
        for (int i = 0; i < 5; ++i) pack.sweep();
        for (const unsigned body : {9u, 11u, 14u, 15u, Pack::kBodies})
            EXPECT_TRUE(std::equal(pack.velocities()[body].columns, pack.velocities()[body].columns + 6,
                                   same.velocities()[body].columns));
    });
}

TEST(ContactSweep, HasTheSameBitsOnEveryInstructionSet) {
    std::vector<double> first;
    onAllInstructionSets([&first] {
        std::vector<double> numbers;
        for (unsigned seed = 0; seed < 20; ++seed) {
            Pack pack(seed);
            numbers.push_back(pack.prepare());
            pack.apply();
            for (int i = 0; i < 7; ++i) numbers.push_back(pack.sweep(dReal(1.3)));
            for (const dxSpatialMotion &velocity : pack.velocities())
                numbers.insert(numbers.end(), velocity.columns, velocity.columns + 6);
        }
        if (first.empty()) first = numbers;
        EXPECT_EQ(numbers, first);
    });
}

}  // namespace
