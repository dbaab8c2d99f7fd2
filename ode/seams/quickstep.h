/* Stages of QuickStep are given to workers in pieces; the shuffle of its rows and the sweeps over them are ours
 * (ode_mt/dynamics). Upstream's are static functions in the same file as their calls, so the two are told apart by their
 * argument: a definition's begins with a type, a call's is a variable. Definitions get other names. */
#pragma once

#include "one_thread.h"

#include "dynamics/dxIslandSweeps.h"
#include "dynamics/dxStagePieces.h"

#define dxQuickStepIsland_Stage0_Bodies(argument) dxBodiesSeam_##argument)
#define dxBodiesSeam_dxQuickStepperStage0BodiesCallContext dxUpstreamBodies(dxQuickStepperStage0BodiesCallContext
#define dxBodiesSeam_callContext dxUpstreamBodies(callContext
#define dxBodiesSeam_stage0BodiesCallContext dxStagePieces::prepareBodies(dxUpstreamBodies, stage0BodiesCallContext

#define dxQuickStepIsland_Stage2a(argument) dxJointsSeam_##argument)
#define dxJointsSeam_dxQuickStepperStage2CallContext dxUpstreamJoints(dxQuickStepperStage2CallContext
#define dxJointsSeam_stage2CallContext dxStagePieces::readJoints(dxUpstreamJoints, stage2CallContext

#define dxQuickStepIsland_Stage2c(argument) dxRhsSeam_##argument)
#define dxRhsSeam_dxQuickStepperStage2CallContext dxUpstreamRhs(dxQuickStepperStage2CallContext
#define dxRhsSeam_stage2CallContext dxStagePieces::addRightHandSides(dxUpstreamRhs, stage2CallContext

#define dxQuickStepIsland_Stage4LCP_iMJComputation(argument) dxImpulseSeam_##argument)
#define dxImpulseSeam_dxQuickStepperStage4CallContext dxUpstreamImpulses(dxQuickStepperStage4CallContext
#define dxImpulseSeam_stage4CallContext dxIslandSweeps::computeImpulses(dxUpstreamImpulses, stage4CallContext

#define dxQuickStepIsland_Stage4LCP_AdComputation(argument) dxScaleSeam_##argument)
#define dxScaleSeam_dxQuickStepperStage4CallContext dxUpstreamScale(dxQuickStepperStage4CallContext
#define dxScaleSeam_stage4CallContext dxIslandSweeps::scaleRows(dxUpstreamScale, stage4CallContext

#define dxQuickStepIsland_Stage4LCP_ConstraintsShuffling(argument, iteration) dxShuffleSeam_##argument, iteration)
#define dxShuffleSeam_dxQuickStepperStage4CallContext dxUpstreamShuffle(dxQuickStepperStage4CallContext
#define dxShuffleSeam_stage4CallContext dxIslandSweeps::shuffle(stage4CallContext

#define dxQuickStepIsland_Stage4LCP_STIteration(argument) dxSweepSeam_##argument)
#define dxSweepSeam_dxQuickStepperStage4CallContext dxUpstreamSweep(dxQuickStepperStage4CallContext
#define dxSweepSeam_stage4CallContext dxIslandSweeps::sweep(stage4CallContext

#define dxQuickStepIsland_Stage4b(argument) dxResultsSeam_##argument)
#define dxResultsSeam_dxQuickStepperStage4CallContext dxUpstreamResults(dxQuickStepperStage4CallContext
#define dxResultsSeam_stage4CallContext dxIslandSweeps::giveResults(stage4CallContext), dxUpstreamResults(stage4CallContext

#define dxQuickStepIsland_Stage6b(argument) dxMoveSeam_##argument)
#define dxMoveSeam_dxQuickStepperStage6CallContext dxUpstreamMove(dxQuickStepperStage6CallContext
#define dxMoveSeam_stage6CallContext dxStagePieces::moveBodies(dxUpstreamMove, stage6CallContext
