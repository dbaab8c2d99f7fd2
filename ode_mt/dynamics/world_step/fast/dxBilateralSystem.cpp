#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/fast/dxBilateralSystem.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include "core/dxNoIndex.h"
#include "dynamics/world_step/fast/dxBodyLanes-inl.h"
#include "dynamics/world_step/fast/dxBilateralSystem.h"
#include "dynamics/world_step/fast/dxRowBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace dxFastStepKernels {
namespace HWY_NAMESPACE {

// The sum of a column's lanes: halves are added until one is left, so that its order is the same for every width.
template <unsigned kLanes>
HWY_INLINE double addUpLanes(const double *lanes) {
    if constexpr (kLanes == dxBilateralSystem::kBallLanes)
        return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
    else
        return addUp(lanes);
}

// Linear rows of a ball joint for its first body and its second one, and columns of the unit matrix.
alignas(kCacheLine) constexpr double kBallSigns[2][kBodyLanes] = {{1, 1, 1}, {-1, -1, -1}};
alignas(kCacheLine) constexpr double kUnits[3][kBodyLanes] = {{1}, {0, 1}, {0, 0, 1}};

// `kBalls`: all joints are ball joints, and linear columns are not read.
template <bool kBalls>
class BilateralSystem {
    static constexpr unsigned kLanes = kBalls ? dxBilateralSystem::kBallLanes : kBodyLanes;
    static constexpr unsigned kMaxRows = kBalls ? dxBilateralSystem::kBallLanes : kBodyAxes;  // columns of a block
    using Tag = hn::CappedTag<double, kLanes>;
    using Lanes = hn::Vec<Tag>;
    using System = dxBilateralSystem;

public:
    explicit BilateralSystem(dxBilateralSystem &system) : m_system(system), m_order(system.order) {}

    // Making a joint's blocks and eliminating them alternate: the latter waits for divisions, the former fills the gaps.
    HWY_INLINE bool solve(const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
        const unsigned count = static_cast<unsigned>(m_system.joints.size());
        for (unsigned joint = 0; joint < count; ++joint) {
            bool isRegular = true;
            withRows(m_system.joints[joint].rows, [&](auto rows) HWY_ATTR {
                isRegular = makeAndEliminate<decltype(rows)::value>(joint, inverseMasses, motions);
            });
            if (!isRegular) return false;
        }
        m_system.largestB = largestB();
        for (unsigned joint = count; joint-- > 0;)
            withRows(m_system.joints[joint].rows, [&](auto rows) HWY_ATTR { substitute<decltype(rows)::value>(joint); });
        return true;
    }

    // The blocks of a front's joints, and b. Returns the largest |b|.
    HWY_INLINE double makeFront(const dxFrontPlan::Front &front, const dxFrontNumbers &numbers, const dxInverseMass *inverseMasses,
                                const dxBodyVector *motions) {
        for (unsigned joint = front.begin; joint < front.end; ++joint)
            withRows(m_system.joints[joint].rows, [&](auto rows) HWY_ATTR {
                makeInFront<decltype(rows)::value>(joint, front, numbers, inverseMasses, motions);
            });
        return largestB();
    }

    HWY_INLINE dxBilateralSizes findResidual(const dxBodyVector *accelerations) {
        const Tag d;
        alignas(kCacheLine) double worst[kLanes] = {}, largestSum[kLanes] = {}, zeros[kLanes] = {};
        for (unsigned joint = 0; joint < m_system.joints.size(); ++joint) {
            const unsigned *const bodies = m_system.joints[joint].bodies;
            for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
                const auto force = load(joint, System::kForce, lane);
                auto w = hn::Sub(hn::Mul(load(joint, System::kSoftness, lane), force), load(joint, System::kGiven, lane));
                for (unsigned side = 0; side < 2 && bodies[side] != kNoIndex; ++side)
                    w = hn::Add(w, multiply(joint, side, lane, accelerations[bodies[side]].lane));
                const auto sum = hn::Abs(hn::Mul(load(joint, System::kDiagonal, lane), force));
                hn::Store(hn::Max(hn::Load(d, worst + lane), hn::Abs(w)), d, worst + lane);
                hn::Store(hn::Max(hn::Load(d, largestSum + lane), sum), d, largestSum + lane);
                // What is not finite makes it NaN.
                hn::Store(hn::Add(hn::Load(d, zeros + lane), hn::Mul(hn::Add(w, sum), hn::Zero(d))), d, zeros + lane);
            }
        }
        dxBilateralSizes sizes;
        for (unsigned lane = 0; lane < kLanes; ++lane) {
            sizes.residual = HWY_MAX(sizes.residual, worst[lane]);
            sizes.sum = HWY_MAX(sizes.sum, largestSum[lane]);
            if (zeros[lane] != 0) sizes.residual = sizes.sum = std::numeric_limits<double>::infinity();
        }
        return sizes;
    }

private:
    static constexpr unsigned kDiagonal = kNoIndex;  // block

    HWY_INLINE double largestB() const {
        double all = 0;
        for (const double largest : m_largestB) all = HWY_MAX(all, largest);
        return all;
    }

    // Calls work(rows), the number being a constant in it.
    template <class Work>
    static HWY_INLINE void withRows(unsigned rows, const Work &work) {
        if (kBalls || rows == 3) return work(std::integral_constant<unsigned, 3>());  // most bilateral joints are ball joints
        if constexpr (!kBalls) dxFastStepKernels::HWY_NAMESPACE::withRows(rows, work);
    }

    HWY_INLINE double *vectorOf(unsigned joint, System::Vector which) {
        return reinterpret_cast<double *>(m_system.vectors.data()) + (std::size_t(joint) * System::kVectors + which) * kLanes;
    }
    HWY_INLINE double *columnsOf(dxBodyVectors &array, std::size_t block) {
        return reinterpret_cast<double *>(array.data()) + block * kMaxRows * kLanes;
    }
    HWY_INLINE const double *jacobianOf(std::size_t jointSide) {
        return reinterpret_cast<const double *>(m_system.jacobian.data()) + jointSide * kBodyAxes * kLanes;
    }
    HWY_INLINE Lanes load(unsigned joint, System::Vector which, unsigned lane) {
        return hn::Load(Tag(), vectorOf(joint, which) + lane);
    }

    // A joint's rows for one of its bodies, a lane each, times the body's six numbers.
    HWY_INLINE Lanes multiply(unsigned joint, unsigned side, unsigned lane, const double *motion) {
        const Tag d;
        const double *const columns = jacobianOf(2 * joint + side) + lane;
        const auto product = [&](unsigned k) HWY_ATTR { return hn::Mul(hn::Load(d, columns + k * kLanes), hn::Set(d, motion[k])); };
        const auto angular = hn::Add(hn::Add(product(3), product(4)), product(5));
        if constexpr (kBalls)
            return hn::Add(hn::Mul(hn::Load(d, motion + lane), hn::Load(d, kBallSigns[side] + lane)), angular);
        else
            return hn::Add(hn::Add(hn::Add(product(0), product(1)), product(2)), angular);
    }

    // columns(row) += byMass(row) * rows', for the first kRows rows of the former; without the linear part of ball joints.
    template <unsigned kRows>
    static HWY_INLINE void addProducts(const double *byMass, const double *rows, unsigned lane, Lanes *columns) {
        const Tag d;
        Lanes loaded[kBodyAxes];
        for (unsigned k = kBalls ? 3 : 0; k < kBodyAxes; ++k) loaded[k] = hn::Load(d, rows + k * kLanes + lane);
        HWY_UNROLL(6) for (unsigned row = 0; row < kRows; ++row) {
            const auto product = [&](unsigned k) HWY_ATTR { return hn::Mul(hn::Set(d, byMass[k * kLanes + row]), loaded[k]); };
            auto sum = hn::Add(hn::Add(product(3), product(4)), product(5));
            if constexpr (!kBalls) sum = hn::Add(hn::Add(hn::Add(product(0), product(1)), product(2)), sum);
            columns[row] = hn::Add(columns[row], sum);
        }
    }

    // Columns before products are added: the linear part of ball joints, a multiple of the unit matrix.
    template <unsigned kRows>
    static HWY_INLINE void begin(double linear, unsigned lane, Lanes *columns) {
        const Tag d;
        for (unsigned row = 0; row < kRows; ++row) {
            if constexpr (kBalls)
                columns[row] = hn::Mul(hn::Set(d, linear), hn::Load(d, kUnits[row] + lane));
            else
                columns[row] = hn::Zero(d);
        }
    }

    // The linear part of a block of two joints.
    HWY_INLINE double linearOf(unsigned joint, unsigned block, const dxInverseMass *inverseMasses) {
        double sum = 0;
        if constexpr (kBalls)
            for (unsigned i = m_system.firstPair[block]; i < m_system.firstPair[block + 1]; ++i) {
                const System::Pair &pair = m_system.pairs[i];
                const double mass = inverseMasses[m_system.joints[joint].bodies[pair.side]].mass;
                sum += pair.side == pair.other % 2 ? mass : -mass;
            }
        return sum;
    }

    // Functions of their own: inlined for each pair of numbers of rows, the file would be much code.
    template <unsigned kRows>
    HWY_NOINLINE bool makeAndEliminate(unsigned joint, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
        const auto placeOf = [&](unsigned block) HWY_ATTR {
            return block == kDiagonal ? columnsOf(m_system.diagonal, joint) : columnsOf(m_system.below, block);
        };
        make<kRows, false>(joint, inverseMasses, motions, placeOf, [](unsigned) {});
        return eliminate<kRows>(joint);
    }

    // The joint's block of the diagonal, those below it, and b. placeOf(block) is where columns of a block are to be written, and block kDiagonal
    // the diagonal's; isMade(block) is called when they are there. `kIsSparse`: without blocks that are fill, and not made.
    template <unsigned kRows, bool kIsSparse, class PlaceOf, class IsMade>
    HWY_INLINE void make(unsigned joint, const dxInverseMass *inverseMasses, const dxBodyVector *motions, const PlaceOf &placeOf,
                         const IsMade &isMade) {
        const Tag d;
        const unsigned *const bodies = m_system.joints[joint].bodies;
        const unsigned sides = bodies[1] != kNoIndex ? 2 : 1;
        alignas(kCacheLine) double byMass[2][kBodyAxes * kLanes];
        for (unsigned side = 0; side < sides; ++side)
            multiplyByInverseMass<kLanes, !kBalls>(jacobianOf(2 * joint + side), inverseMasses[bodies[side]], byMass[side]);
        double *const diagonal = placeOf(kDiagonal);
        const double mass = inverseMasses[bodies[0]].mass + (sides > 1 ? inverseMasses[bodies[1]].mass : 0);
        for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
            Lanes columns[kRows];
            begin<kRows>(mass, lane, columns);
            auto b = load(joint, System::kGiven, lane);
            for (unsigned side = 0; side < sides; ++side) {
                addProducts<kRows>(byMass[side], jacobianOf(2 * joint + side), lane, columns);
                b = hn::Sub(b, multiply(joint, side, lane, motions[bodies[side]].lane));
            }
            for (unsigned row = 0; row < kRows; ++row) hn::Store(columns[row], d, diagonal + row * kLanes + lane);
            hn::Store(b, d, vectorOf(joint, System::kRightSide) + lane);
            hn::Store(hn::Max(hn::Load(d, m_largestB + lane), hn::Abs(b)), d, m_largestB + lane);
        }
        for (unsigned row = 0; row < kRows; ++row)
            vectorOf(joint, System::kDiagonal)[row] = diagonal[row * kLanes + row] += vectorOf(joint, System::kSoftness)[row];
        isMade(kDiagonal);
        for (unsigned block = m_order.firstBlock(joint); block < m_order.firstBlock(joint + 1); ++block) {
            if (kIsSparse && m_system.firstPair[block] == m_system.firstPair[block + 1]) continue;
            double *const below = placeOf(block);
            const double linear = linearOf(joint, block, inverseMasses);
            for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
                Lanes columns[kRows];
                begin<kRows>(linear, lane, columns);
                for (unsigned i = m_system.firstPair[block]; i < m_system.firstPair[block + 1]; ++i)
                    addProducts<kRows>(byMass[m_system.pairs[i].side], jacobianOf(m_system.pairs[i].other), lane, columns);
                for (unsigned row = 0; row < kRows; ++row) hn::Store(columns[row], d, below + row * kLanes + lane);
            }
            isMade(block);
        }
    }

    template <unsigned kRows>
    HWY_NOINLINE void makeInFront(unsigned joint, const dxFrontPlan::Front &front, const dxFrontNumbers &numbers,
                                  const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
        alignas(kCacheLine) double columns[kRows * kLanes];
        const unsigned place = joint - front.begin, firstColumn = m_system.frontPlan.rowOf(front, place);
        const auto isMade = [&](unsigned block) {
            const unsigned other = block == kDiagonal ? joint : m_order.rowOf(block);
            const unsigned index = block == kDiagonal ? place : place + 1 + block - m_order.firstBlock(joint);  // in the front
            const unsigned firstRow = m_system.frontPlan.rowOf(front, index);
            for (unsigned column = 0; column < kRows; ++column)
                for (unsigned row = 0; row < m_system.joints[other].rows; ++row)
                    numbers.column(firstColumn + column)[firstRow + row] = columns[column * kLanes + row];
        };
        make<kRows, true>(joint, inverseMasses, motions, [&](unsigned) { return columns; }, isMade);
        const double *const b = vectorOf(joint, System::kRightSide);
        for (unsigned row = 0; row < kRows; ++row) numbers.column(firstColumn + row)[numbers.columns()] = b[row];
    }

    template <unsigned kRows>
    HWY_INLINE bool eliminate(unsigned joint) {
        const unsigned begin = m_order.firstBlock(joint), end = m_order.firstBlock(joint + 1);
        const unsigned firstEntry = m_order.firstEntry(joint), endEntry = m_order.firstEntry(joint + 1);
        if (end - begin > 0 && endEntry > firstEntry)
            for (unsigned block = begin; block < end; ++block) m_system.slotOf[m_order.rowOf(block)] = block;
        for (unsigned i = firstEntry; i < endEntry; ++i) {
            const dxEliminationOrder::RowEntry &entry = m_order.entry(i);
            withRows(m_system.joints[entry.column].rows, [&](auto count) HWY_ATTR {
                if constexpr (kBalls)
                    subtractEarlier<3>(joint, std::integral_constant<unsigned, 3>(), entry);
                else
                    subtractEarlierOf<decltype(count)::value>(joint, kRows, entry);
            });
        }
        if (!factorPivot<kRows>(joint)) return false;
        for (unsigned block = begin; block < end; ++block) divide<kRows>(joint, columnsOf(m_system.below, block));
        return true;
    }

    template <unsigned kCount>
    HWY_NOINLINE void subtractEarlierOf(unsigned joint, unsigned rows, const dxEliminationOrder::RowEntry &entry) {
        subtractEarlier<kCount>(joint, rows, entry);
    }

    // The products of an earlier joint's kCount rows, where its column has blocks.
    template <unsigned kCount, class Rows>
    HWY_INLINE void subtractEarlier(unsigned joint, Rows rows, const dxEliminationOrder::RowEntry &entry) {
        const Tag d;
        const double *const own = columnsOf(m_system.below, entry.block);
        const double *const pivots = vectorOf(entry.column, System::kInversePivot);
        const auto subtractFrom = [&](double *target, const double *source, double *rightSide) HWY_ATTR {
            for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
                Lanes scaled[kCount];
                for (unsigned p = 0; p < kCount; ++p)
                    scaled[p] = hn::Mul(hn::Load(d, source + p * kLanes + lane), hn::Set(d, pivots[p]));
                for (unsigned row = 0; row < rows; ++row) {
                    auto sum = hn::Load(d, target + row * kLanes + lane);
                    for (unsigned p = 0; p < kCount; ++p) sum = hn::Sub(sum, hn::Mul(hn::Set(d, own[p * kLanes + row]), scaled[p]));
                    hn::Store(sum, d, target + row * kLanes + lane);
                }
                if (rightSide == nullptr) continue;
                const double *const b = vectorOf(entry.column, System::kRightSide);
                auto sum = hn::Load(d, rightSide + lane);
                for (unsigned p = 0; p < kCount; ++p) sum = hn::Sub(sum, hn::Mul(hn::Set(d, b[p]), scaled[p]));
                hn::Store(sum, d, rightSide + lane);
            }
        };
        subtractFrom(columnsOf(m_system.diagonal, joint), own, vectorOf(joint, System::kRightSide));
        for (unsigned source = entry.block + 1; source < m_order.firstBlock(entry.column + 1); ++source)
            subtractFrom(columnsOf(m_system.below, m_system.slotOf[m_order.rowOf(source)]), columnsOf(m_system.below, source), nullptr);
    }

    // L D L' of a joint's own rows: L' in the place of the upper triangle. inv(L) b.
    template <unsigned kRows>
    HWY_INLINE bool factorPivot(unsigned joint) {
        double *const block = columnsOf(m_system.diagonal, joint);
        double *const inverses = vectorOf(joint, System::kInversePivot), *const b = vectorOf(joint, System::kRightSide);
        const double *const before = vectorOf(joint, System::kDiagonal);
        double rows[kRows][kRows];
        for (unsigned r = 0; r < kRows; ++r)
            for (unsigned s = r; s < kRows; ++s) rows[r][s] = block[r * kLanes + s];
        bool isRegular = true;
        HWY_UNROLL(6) for (unsigned r = 0; r < kRows; ++r) {
            const double pivot = rows[r][r];
            isRegular &= pivot > kMinPivot * before[r] && pivot < std::numeric_limits<double>::infinity();
            const double inverse = 1 / pivot, known = b[r];
            inverses[r] = inverse;
            for (unsigned s = r + 1; s < kRows; ++s) {
                const double factor = rows[r][s] * inverse;
                for (unsigned k = s; k < kRows; ++k) rows[s][k] -= factor * rows[r][k];
                block[r * kLanes + s] = factor;
                b[s] -= factor * known;
            }
        }
        return isRegular;
    }

    // inv(L) times the columns of a block below.
    template <unsigned kRows>
    HWY_INLINE void divide(unsigned joint, double *below) {
        const Tag d;
        const double *const factor = columnsOf(m_system.diagonal, joint);
        for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
            Lanes known[kRows];
            known[0] = hn::Load(d, below + lane);
            HWY_UNROLL(6) for (unsigned s = 1; s < kRows; ++s) {
                auto sum = hn::Load(d, below + s * kLanes + lane);
                for (unsigned r = 0; r < s; ++r) sum = hn::Sub(sum, hn::Mul(hn::Set(d, factor[r * kLanes + s]), known[r]));
                known[s] = sum;
                hn::Store(sum, d, below + s * kLanes + lane);
            }
        }
    }

    // The forces of a joint from those of later ones.
    template <unsigned kRows>
    HWY_NOINLINE void substitute(unsigned joint) {
        const Tag d;
        alignas(kCacheLine) double sums[kRows][kLanes];
        for (unsigned lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
            Lanes sum[kRows];
            for (unsigned row = 0; row < kRows; ++row) sum[row] = hn::Zero(d);
            for (unsigned block = m_order.firstBlock(joint); block < m_order.firstBlock(joint + 1); ++block) {
                const double *const below = columnsOf(m_system.below, block);
                const auto known = load(m_order.rowOf(block), System::kForce, lane);
                for (unsigned row = 0; row < kRows; ++row)
                    sum[row] = hn::Add(sum[row], hn::Mul(hn::Load(d, below + row * kLanes + lane), known));
            }
            for (unsigned row = 0; row < kRows; ++row) hn::Store(sum[row], d, sums[row] + lane);
        }
        const double *const factor = columnsOf(m_system.diagonal, joint);
        const double *const b = vectorOf(joint, System::kRightSide), *const inverses = vectorOf(joint, System::kInversePivot);
        double *const force = vectorOf(joint, System::kForce);
        for (unsigned row = kRows; row-- > 0;) {
            double sum = (b[row] - addUpLanes<kLanes>(sums[row])) * inverses[row];
            for (unsigned other = row + 1; other < kRows; ++other) sum -= factor[row * kLanes + other] * force[other];
            force[row] = sum;
        }
    }

    dxBilateralSystem &m_system;
    const dxEliminationOrder &m_order;
    alignas(kCacheLine) double m_largestB[kLanes] = {};
};

bool solveBilateral(dxBilateralSystem &system, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    return system.isBalls ? BilateralSystem<true>(system).solve(inverseMasses, motions)
                          : BilateralSystem<false>(system).solve(inverseMasses, motions);
}

double makeFront(dxBilateralSystem &system, const dxFrontPlan::Front &front, const dxFrontNumbers &numbers, const dxInverseMass *inverseMasses,
                 const dxBodyVector *motions) {
    return system.isBalls ? BilateralSystem<true>(system).makeFront(front, numbers, inverseMasses, motions)
                          : BilateralSystem<false>(system).makeFront(front, numbers, inverseMasses, motions);
}

dxBilateralSizes findBilateralResidual(dxBilateralSystem &system, const dxBodyVector *accelerations) {
    return system.isBalls ? BilateralSystem<true>(system).findResidual(accelerations)
                          : BilateralSystem<false>(system).findResidual(accelerations);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxFastStepKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxFastStepKernels {
HWY_EXPORT(solveBilateral);
HWY_EXPORT(makeFront);
HWY_EXPORT(findBilateralResidual);
}  // namespace dxFastStepKernels

namespace {

// From this many products of two blocks of a column on, for each joint, fronts take less time: nets of 19 by 19 balls on ball joints. Columns of
// other joints have eight lanes, which those of six rows fill best: for these it is nets of 40 by 40.
constexpr double kMinProductsOfBalls = 75, kMinProductsOfOthers = 90, kMinProductsOfSixRows = 190;

double minProductsOf(const dxBilateralSystem &system) {
    if (system.isBalls) return kMinProductsOfBalls;
    double rows = 0;
    for (const dxBilateralJoint &joint : system.joints) rows += joint.rows;
    const double beyondFive = std::max(rows / double(system.joints.size()) - 5, 0.0);
    return kMinProductsOfOthers + (kMinProductsOfSixRows - kMinProductsOfOthers) * beyondFive;
}

double productsOf(const dxEliminationOrder &order) {
    double products = 0;
    for (unsigned joint = 0; joint < order.bodyCount(); ++joint) {
        const double blocks = order.firstBlock(joint + 1) - order.firstBlock(joint);
        products += blocks * (blocks + 1) / 2;
    }
    return products;
}

}  // namespace

void dxBilateralSystem::takeMemory() {
    const std::size_t count = joints.size(), lines = kBodyLanes / lanes();  // columns in a dxBodyVector
    const auto clear = [lines](dxBodyVectors &array, std::size_t columns) { array.assign((columns + lines - 1) / lines, dxBodyVector{}); };
    clear(jacobian, 2 * count * kBodyAxes);
    clear(vectors, count * kVectors);
    isInFronts = productsOf(order) >= minProductsOf(*this) * double(count);
    if (isInFronts) {
        std::vector<unsigned> rowsOf;
        for (const dxBilateralJoint &joint : joints) rowsOf.push_back(joint.rows);
        frontPlan.make(order, rowsOf);
        fronts.shape(frontPlan);
        return;
    }
    clear(diagonal, count * columns());
    clear(below, std::size_t(order.blockCount()) * columns());
    slotOf.assign(count, 0);
}

bool dxBilateralSystem::solve(dxTaskRunner &runner, const dxInverseMass *inverseMasses, const dxBodyVector *motions) {
    if (!isInFronts) return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::solveBilateral)(*this, inverseMasses, motions);
    phases.reserve(runner.workers());
    fronts.reserve(runner.workers());
    largestBOf.assign(runner.workers(), 0);
    bool isRegular = false;
    phases.run(dxParallelStage::Fronts, runner, [&] {
        isRegular = fronts.factorise(phases, [&](const dxFrontPlan::Front &front, const dxFrontNumbers &numbers, unsigned share) {
            const double largest = HWY_DYNAMIC_DISPATCH(dxFastStepKernels::makeFront)(*this, front, numbers, inverseMasses, motions);
            largestBOf[share] = std::max(largestBOf[share], largest);
        });
        if (isRegular) fronts.substitute(phases);
    });
    largestB = *std::max_element(largestBOf.begin(), largestBOf.end());
    for (unsigned joint = 0; joint < joints.size() && isRegular; ++joint)
        std::copy_n(fronts.solutionOf(joint), joints[joint].rows, vectorOf(joint, kForce));
    return isRegular;
}

dxBilateralSizes dxBilateralSystem::findResidual(const dxBodyVector *accelerations) {
    return HWY_DYNAMIC_DISPATCH(dxFastStepKernels::findBilateralResidual)(*this, accelerations);
}
#endif
