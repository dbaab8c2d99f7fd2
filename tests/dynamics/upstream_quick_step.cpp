#include "quickstep.cpp"  // upstream's: its stages are static functions

#include "upstream_facts.h"
#include "upstream_quick_step.h"

namespace {

std::vector<dReal> forcesOf(const dxIsland &island) {
    std::vector<dReal> forces;
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        const dxBody *const body = island.bodies[i];
        forces.insert(forces.end(), body->facc, body->facc + 3);
        forces.insert(forces.end(), body->tacc, body->tacc + 3);
    }
    return forces;
}

}  // namespace

UpstreamQuickStep stepByUpstream(dxWorld *world, dReal stepSize, const dxIsland &island) {
    UpstreamQuickStep seen;
    dxStepperProcessingCallContext step = dxSerialStepperCall(world, stepSize, nullptr, island.bodies, island.joints);
    const unsigned bodyCount = island.bodyCount;
    step.AssignIslandSelection(island.bodies, island.joints, bodyCount, island.jointCount);

    seen.invInertia.resize(12 * bodyCount);
    dxQuickStepperStage0BodiesCallContext gather;
    gather.Initialize(&step, seen.invInertia.data());
    dxQuickStepIsland_Stage0_Bodies(&gather);
    seen.forces = forcesOf(island);

    std::vector<dJointWithInfo1> infos(island.jointCount);
    dxQuickStepperStage0Outputs counts;
    dxQuickStepperStage0JointsCallContext count;
    count.Initialize(&step, infos.data(), &counts);
    dxQuickStepIsland_Stage0_Joints(&count);
    const unsigned rows = counts.m;

    std::vector<dxMIndexItem> index(1, dxMIndexItem{0, 0});
    for (unsigned i = 0; i < counts.nj; ++i) {
        dxMIndexItem next = index.back();
        next.mIndex += infos[i].info.m;
        if (infos[i].joint->feedback) next.fbIndex += infos[i].info.m;
        index.push_back(next);
    }
    std::vector<dxJBodiesItem> rowBodies(rows);
    seen.boundingRow.resize(rows);
    seen.scaledJacobian.resize(16 * rows);
    std::vector<dReal> copies(12 * counts.mfb + 1);
    dxQuickStepperLocalContext local;
    local.Initialize(seen.invInertia.data(), infos.data(), counts.nj, rows, counts.mfb, index.data(), rowBodies.data(),
                     seen.boundingRow.data(), seen.scaledJacobian.data(), copies.data());
    if (rows > 0) {
        seen.freeAcceleration.resize(6 * bodyCount);
        dxQuickStepperStage2CallContext read;
        read.Initialize(&step, &local, seen.freeAcceleration.data());
        dxQuickStepIsland_Stage2a(&read);
        seen.jacobian = seen.scaledJacobian;
        for (const dxJBodiesItem &pair : rowBodies) seen.bodies.insert(seen.bodies.end(), {int(pair.first), pair.second});
        dxQuickStepIsland_Stage2b(&read);
        dxQuickStepIsland_Stage2c(&read);

        seen.lambda.resize(rows);
        seen.acceleration.resize(6 * bodyCount);
        seen.impulse.resize(12 * rows);
        std::vector<IndexError> order(rows);
        std::vector<atomicord32> links(2 * (rows + 1)), levels(dMAX(bodyCount, rows));
        dxQuickStepperStage4CallContext solve;
        solve.Initialize(&step, &local, seen.lambda.data(), seen.acceleration.data(), seen.impulse.data(), order.data(), nullptr,
                         levels.data(), links.data());
        dxQuickStepIsland_Stage4a(&solve);
        dxQuickStepIsland_Stage4LCP_iMJComputation(&solve);
        dxQuickStepIsland_Stage4LCP_STfcComputation(&solve);
        dxQuickStepIsland_Stage4LCP_AdComputation(&solve);
        dxQuickStepIsland_Stage4LCP_ReorderPrep(&solve);
        for (const IndexError &entry : order) seen.order.push_back(entry.index);
        for (unsigned i = 0; i < unsigned(world->qs.num_iterations); ++i) {
            if (IsSORConstraintsReorderRequiredForIteration(i)) {
                solve.ResetSOR_ConstraintsReorderVariables(0);
                dxQuickStepIsland_Stage4LCP_ConstraintsShuffling(&solve, i);
            }
            dxQuickStepIsland_Stage4LCP_STIteration(&solve);
        }
        dxQuickStepIsland_Stage4b(&solve);
    }
    dxQuickStepperStage6CallContext move;
    move.Initialize(&step, &local);
    dxQuickStepIsland_Stage6a(&move);
    dxQuickStepIsland_Stage6b(&move);
    return seen;
}
