#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/quick_step/fast/dxJointSweep.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include "core/dxFlushSubnormals.h"
#include "dynamics/quick_step/fast/dxJointSweep.h"
#include "dynamics/quick_step/fast/dxLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxJointKernels {
namespace HWY_NAMESPACE {

using namespace dxLaneKernels::HWY_NAMESPACE;

// How A and B move: A relative to B, and B's rotation.
struct JointMotion {
    Vector v, w, wB;

    static HWY_INLINE JointMotion load(const dxLaneBodies &bodies, unsigned first, const dxSpatialMotion *velocities) {
        const dReal *rows[2][kLanes];
        for (unsigned side = 0; side < 2; ++side)
            for (unsigned i = 0; i < kLanes; ++i) rows[side][i] = velocities[bodies.source[side][first + i]].columns;
        const Motion difference = loadDifference(rows[0], rows[1]), bodyB = loadMotion(rows[1]);
        return {{difference.column[0], difference.column[1], difference.column[2]},
                {difference.column[3], difference.column[4], difference.column[5]},
                {bodyB.column[3], bodyB.column[4], bodyB.column[5]}};
    }
};

// The directions of a row.
struct Jacobian {
    Vector linear, onA, together;

    static HWY_INLINE Jacobian load(const dxJointLanes &row, unsigned first) {
        return {loadVector(row.linear, first), loadVector(row.angular, first), loadVector(row.together, first)};
    }
    HWY_INLINE Vector onB() const { return subtract(together, onA); }
    HWY_INLINE Lane velocityOf(const JointMotion &motion) const {
        return hn::Add(hn::Add(dot(linear, motion.v), dot(onA, motion.w)), dot(together, motion.wB));
    }
};

HWY_INLINE Lane within(Lane low, Lane high, Lane a) { return hn::IfThenElse(hn::Gt(a, high), high, atLeast(low, a)); }

// Returns bias - softness p - J u.
HWY_INLINE Lane residualOf(const dxJointLanes &row, const Jacobian &jacobian, const JointMotion &motion, Lane impulse, unsigned first) {
    const Lane yielding = hn::Mul(loadLanes(row.softness, first), impulse);
    return hn::Sub(hn::Sub(loadLanes(row.bias, first), yielding), jacobian.velocityOf(motion));
}

// Calls work(number of the pack, pack, first lane) for kLanes joints at a time.
template <class Work>
HWY_INLINE void forPacks(const dxJointPacks &joints, unsigned begin, unsigned end, const Work &work) {
    for (unsigned i = begin; i < end; ++i)
        for (unsigned first = 0; first < dxLanes::kCount; first += kLanes) work(i, joints.packs[i], first);
}

double prepare(const dxJointPacks &joints, unsigned begin, unsigned end, const dxSpatialMotion *velocities) {
    clearEnergies(joints.energies, begin, end);
    Energy energy(joints.energies);
    forPacks(joints, begin, end, [&](unsigned number, const dxJointPack &pack, unsigned first) HWY_ATTR {
        const Masses massesA = Masses::load(pack, 0, first), massesB = Masses::load(pack, 1, first);
        const JointMotion motion = JointMotion::load(pack, first, velocities);
        Lane sum = hn::Zero(LaneTag());
        for (unsigned k = 0; k < pack.rowCount; ++k) {
            dxJointLanes &row = joints.rows[pack.firstRow + k];
            const Jacobian jacobian = Jacobian::load(row, first);
            const Lane linear = hn::Mul(hn::Add(massesA.invMass, massesB.invMass), dot(jacobian.linear, jacobian.linear));
            const Lane angular = hn::Add(dot(jacobian.onA, massesA.turn(jacobian.onA)), dot(jacobian.onB(), massesB.turn(jacobian.onB())));
            const Lane effectiveMass = inverseOf(hn::Add(hn::Add(linear, angular), loadLanes(row.softness, first)));
            storeLanes(effectiveMass, row.effectiveMass, first);
            storeLanes(within(loadLanes(row.low, first), loadLanes(row.high, first), loadLanes(row.impulse, first)), row.impulse, first);
            const Lane residual = residualOf(row, jacobian, motion, hn::Zero(LaneTag()), first);
            const Lane impulse = within(loadLanes(row.low, first), loadLanes(row.high, first), hn::Mul(residual, effectiveMass));
            sum = hn::Add(sum, hn::Abs(hn::Mul(impulse, residual)));
        }
        energy.add(number, sum, first);
    });
    return energy.sum();
}

// What the rows of a joint change.
struct JointChanges {
    Vector push, turnA, turnB;

    static HWY_INLINE JointChanges none() {
        const Vector zero = Changes::none().v;
        return {zero, zero, zero};
    }
    HWY_INLINE void addTo(const dxLaneBodies &bodies, unsigned first, const Masses &massesA, const Masses &massesB, dxSpatialMotion *velocities,
                          dxSpatialMotion (&elsewhere)[2][dxLanes::kCount]) const {
        Changes{scale(push, massesA.invMass), turnA}.addTo(bodies, 0, first, velocities, elsewhere[0]);
        Changes{scale(push, hn::Neg(massesB.invMass)), turnB}.addTo(bodies, 1, first, velocities, elsewhere[1]);
    }
};

// Lets a change of a row's impulse act.
HWY_INLINE void actOn(const Jacobian &jacobian, Lane change, const Masses &massesA, const Masses &massesB, Lane inverseMass, JointMotion &motion,
                      JointChanges &changes) {
    const Vector linear = scale(jacobian.linear, change);
    const Vector turnA = massesA.turn(scale(jacobian.onA, change)), turnB = massesB.turn(scale(jacobian.onB(), change));
    changes.push = add(changes.push, linear);
    changes.turnA = add(changes.turnA, turnA);
    changes.turnB = add(changes.turnB, turnB);
    motion.v = add(motion.v, scale(linear, inverseMass));
    motion.w = add(motion.w, subtract(turnA, turnB));
    motion.wB = add(motion.wB, turnB);
}

// Calls work(row, its Jacobian, motion, act) for the rows of kLanes joints at a time, where act(change) lets a change of the row's impulse act, and
// returns an energy.
template <class Work>
HWY_INLINE double forMovingRows(const dxJointPacks &joints, unsigned begin, unsigned end, dxSpatialMotion *velocities, const Work &work) {
    clearEnergies(joints.energies, begin, end);
    Energy energy(joints.energies);
    dxSpatialMotion elsewhere[2][dxLanes::kCount] = {};
    forPacks(joints, begin, end, [&](unsigned number, const dxJointPack &pack, unsigned first) HWY_ATTR {
        const Masses massesA = Masses::load(pack, 0, first), massesB = Masses::load(pack, 1, first);
        const Lane inverseMass = hn::Add(massesA.invMass, massesB.invMass);
        JointMotion motion = JointMotion::load(pack, first, velocities);
        JointChanges changes = JointChanges::none();
        Lane sum = hn::Zero(LaneTag());
        for (unsigned k = 0; k < pack.rowCount; ++k) {
            dxJointLanes &row = joints.rows[pack.firstRow + k];
            const Jacobian jacobian = Jacobian::load(row, first);
            const auto act = [&](Lane change) HWY_ATTR { actOn(jacobian, change, massesA, massesB, inverseMass, motion, changes); };
            sum = hn::Add(sum, work(row, jacobian, motion, first, act));
        }
        changes.addTo(pack, first, massesA, massesB, velocities, elsewhere);
        energy.add(number, sum, first);
    });
    return energy.sum();
}

// The impulses act one after the other: each works on the mean of the motions before and after it.
double apply(const dxJointPacks &joints, unsigned begin, unsigned end, dxSpatialMotion *velocities) {
    return forMovingRows(joints, begin, end, velocities,
                         [](const dxJointLanes &row, const Jacobian &jacobian, const JointMotion &motion, unsigned first, const auto &act) HWY_ATTR {
                             const Lane impulse = loadLanes(row.impulse, first), half = hn::Set(LaneTag(), 0.5f);
                             const Lane before = jacobian.velocityOf(motion);
                             act(impulse);
                             const Lane mean = hn::Mul(half, hn::Add(before, jacobian.velocityOf(motion)));
                             const Lane yielding = hn::Mul(half, hn::Mul(loadLanes(row.softness, first), impulse));
                             return hn::Mul(impulse, hn::Add(hn::Sub(mean, loadLanes(row.bias, first)), yielding));
                         });
}

double sweep(const dxJointPacks &joints, unsigned begin, unsigned end, dReal factor, dxSpatialMotion *velocities) {
    const Lane relaxation = hn::Set(LaneTag(), static_cast<float>(factor));
    return forMovingRows(joints, begin, end, velocities,
                         [&](dxJointLanes &row, const Jacobian &jacobian, const JointMotion &motion, unsigned first, const auto &act) HWY_ATTR {
                             const Lane impulse = loadLanes(row.impulse, first), residual = residualOf(row, jacobian, motion, impulse, first);
                             const Lane step = hn::Mul(relaxation, loadLanes(row.effectiveMass, first));
                             const Lane wanted = hn::Add(impulse, hn::Mul(residual, step));
                             const Lane next = within(loadLanes(row.low, first), loadLanes(row.high, first), wanted);
                             const Lane change = hn::Sub(next, impulse);
                             storeLanes(next, row.impulse, first);
                             act(change);
                             return hn::Abs(hn::Mul(change, residual));
                         });
}

HWY_INLINE RealWrenches realWrenchesOf(const dxJointPack &pack, const dxJointLanes *rows) {
    RealWrenches wrenches;
    for (unsigned first = 0; first < dxLanes::kCount; first += kReals) {
        const auto zero = hn::Zero(RealTag());
        VectorOf<hn::Vec<RealTag>> push = {zero, zero, zero}, turnA = push, both = push;
        for (unsigned k = 0; k < pack.rowCount; ++k) {
            const auto impulse = loadLanes<RealTag>(rows[k].impulse, first);
            push = add(push, scale(loadVector<RealTag>(rows[k].linear, first), impulse));
            turnA = add(turnA, scale(loadVector<RealTag>(rows[k].angular, first), impulse));
            both = add(both, scale(loadVector<RealTag>(rows[k].together, first), impulse));
        }
        RealWrenches::store(push, wrenches.impulse, first);
        RealWrenches::store(turnA, wrenches.turning[0], first);
        RealWrenches::store(subtract(turnA, both), wrenches.turning[1], first);
    }
    return wrenches;
}

void addImpulses(const dxJointPacks &joints, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities) {
    for (unsigned i = begin; i < end; ++i) {
        const dxJointPack &pack = joints.packs[i];
        realWrenchesOf(pack, joints.rows + pack.firstRow).actOn(pack, masses, velocities);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxJointKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxJointKernels {
HWY_EXPORT(addImpulses);
HWY_EXPORT(apply);
HWY_EXPORT(prepare);
HWY_EXPORT(sweep);
}  // namespace dxJointKernels

double dxPrepareJoints(const dxJointPacks &joints, unsigned begin, unsigned end, const dxSpatialMotion *velocities) {
    using namespace dxJointKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(prepare)(joints, begin, end, velocities);
}

double dxApplyJointImpulses(const dxJointPacks &joints, unsigned begin, unsigned end, dxSpatialMotion *velocities) {
    using namespace dxJointKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(apply)(joints, begin, end, velocities);
}

double dxSweepJoints(const dxJointPacks &joints, unsigned begin, unsigned end, dReal factor, dxSpatialMotion *velocities) {
    using namespace dxJointKernels;
    const dxFlushSubnormals flush;
    return HWY_DYNAMIC_DISPATCH(sweep)(joints, begin, end, factor, velocities);
}

void dxAddJointImpulses(const dxJointPacks &joints, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities) {
    using namespace dxJointKernels;
    HWY_DYNAMIC_DISPATCH(addImpulses)(joints, begin, end, masses, velocities);
}
#endif
