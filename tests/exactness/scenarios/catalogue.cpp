#include "catalogue.h"

#include "additions.h"

#include <utility>

namespace exactness {

Scenario collisionScenario(std::string name, std::string meaning, int steps, Scenario::Make make,
                           Scenario::Callbacks callbacks) {
    Scenario scenario{std::move(name), std::move(meaning), steps, std::move(make)};
    scenario.steppers = {scenes::Stepper::Quick};
    scenario.callbacks = callbacks;
    return scenario;
}

Scenario teamScenario(std::string name, std::string meaning, int steps, Scenario::Make make,
                      scenes::Stepper stepper) {
    Scenario scenario{std::move(name), std::move(meaning), steps, std::move(make)};
    scenario.steppers = {stepper};
    scenario.largeIsland = true;
    return scenario;
}

const Catalogue &catalogue() {
    static const Catalogue scenarios = [] {
        Catalogue all;
        addArraysInCallbacks(all);
        addAutoDisable(all);
        addBallJoints(all);
        addBodyMotion(all);
        addBoxFunctions(all);
        addCallbackLiberties(all);
        addCollideFlags(all);
        addCollisionSpaces(all);
        addConvexCrowds(all);
        addCreation(all);
        addCrowdExtremes(all);
        addDegenerateWorlds(all);
        addDisabledGeoms(all);
        addDoubleJoints(all);
        addFaults(all);
        addFirstMeetings(all);
        addFixedJoints(all);
        addFloatEnvironment(all);
        addFriction(all);
        addGeomDestructors(all);
        addGeomOwnership(all);
        addGeomPairs(all);
        addHashLevels(all);
        addHinge2Joints(all);
        addHingeJoints(all);
        addJointFeedback(all);
        addKinematicBodies(all);
        addLargeExactIslands(all);
        addLargeIslands(all);
        addLeavingHeights(all);
        addLockedSpaces(all);
        addManyContacts(all);
        addManyRows(all);
        addMeshCallbacks(all);
        addMessages(all);
        addMotorJoints(all);
        addMovedCallbacks(all);
        addMovingMeshes(all);
        addPoweredStops(all);
        addPrismaticJoints(all);
        addRandomStream(all);
        addSensors(all);
        addSeveralWorlds(all);
        addSharedScenes(all);
        addSingularIslands(all);
        addSleepingCrowds(all);
        addSliderJoints(all);
        addSpaceChurn(all);
        addSpaceKinds(all);
        addStrayGeoms(all);
        addSweepSpaces(all);
        addTerrain(all);
        addTerrainCrowds(all);
        addTransmissionJoints(all);
        addUniversalJoints(all);
        addUserColliders(all);
        addUserGeomClass(all);
        addUserThreading(all);
        addWanderingRows(all);
        addWideContacts(all);
        addWideExtremes(all);
        addWideLattices(all);
        addWorldParameters(all);
        return all;
    }();
    return scenarios;
}

}  // namespace exactness
