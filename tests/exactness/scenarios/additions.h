// The files of scenarios, each with the function that enters its scenarios in the catalogue.
#pragma once

#include "catalogue.h"

namespace exactness {

void addArraysInCallbacks(Catalogue &catalogue);
void addAutoDisable(Catalogue &catalogue);
void addBallJoints(Catalogue &catalogue);
void addBodyMotion(Catalogue &catalogue);
void addBoxFunctions(Catalogue &catalogue);
void addCallbackLiberties(Catalogue &catalogue);
void addCollideFlags(Catalogue &catalogue);
void addCollisionSpaces(Catalogue &catalogue);
void addConvexCrowds(Catalogue &catalogue);
void addCreation(Catalogue &catalogue);
void addCrowdExtremes(Catalogue &catalogue);
void addDegenerateWorlds(Catalogue &catalogue);
void addDisabledGeoms(Catalogue &catalogue);
void addDoubleJoints(Catalogue &catalogue);
void addFaults(Catalogue &catalogue);
void addFirstMeetings(Catalogue &catalogue);
void addFixedJoints(Catalogue &catalogue);
void addFloatEnvironment(Catalogue &catalogue);
void addFriction(Catalogue &catalogue);
void addGeomDestructors(Catalogue &catalogue);
void addGeomOwnership(Catalogue &catalogue);
void addGeomPairs(Catalogue &catalogue);
void addHashLevels(Catalogue &catalogue);
void addHinge2Joints(Catalogue &catalogue);
void addHingeJoints(Catalogue &catalogue);
void addJointFeedback(Catalogue &catalogue);
void addKinematicBodies(Catalogue &catalogue);
void addLargeExactIslands(Catalogue &catalogue);
void addLargeIslands(Catalogue &catalogue);
void addLeavingHeights(Catalogue &catalogue);
void addLockedSpaces(Catalogue &catalogue);
void addManyContacts(Catalogue &catalogue);
void addManyRows(Catalogue &catalogue);
void addMeshCallbacks(Catalogue &catalogue);
void addMessages(Catalogue &catalogue);
void addMotorJoints(Catalogue &catalogue);
void addMovedCallbacks(Catalogue &catalogue);
void addMovingMeshes(Catalogue &catalogue);
void addPoweredStops(Catalogue &catalogue);
void addPrismaticJoints(Catalogue &catalogue);
void addRandomStream(Catalogue &catalogue);
void addSensors(Catalogue &catalogue);
void addSeveralWorlds(Catalogue &catalogue);
void addSharedScenes(Catalogue &catalogue);
void addSingularIslands(Catalogue &catalogue);
void addSleepingCrowds(Catalogue &catalogue);
void addSliderJoints(Catalogue &catalogue);
void addSpaceChurn(Catalogue &catalogue);
void addSpaceKinds(Catalogue &catalogue);
void addStrayGeoms(Catalogue &catalogue);
void addSweepSpaces(Catalogue &catalogue);
void addTerrain(Catalogue &catalogue);
void addTerrainCrowds(Catalogue &catalogue);
void addTransmissionJoints(Catalogue &catalogue);
void addUniversalJoints(Catalogue &catalogue);
void addUserColliders(Catalogue &catalogue);
void addUserGeomClass(Catalogue &catalogue);
void addUserThreading(Catalogue &catalogue);
void addWanderingRows(Catalogue &catalogue);
void addWideContacts(Catalogue &catalogue);
void addWideExtremes(Catalogue &catalogue);
void addWideLattices(Catalogue &catalogue);
void addWorldParameters(Catalogue &catalogue);

}  // namespace exactness
