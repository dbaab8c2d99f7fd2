// The files of scenarios, each with the function that enters its scenarios in the catalogue.
#pragma once

#include "catalogue.h"

namespace exactness {

void addAutoDisable(Catalogue &catalogue);
void addBallJoints(Catalogue &catalogue);
void addBodyMotion(Catalogue &catalogue);
void addCollisionSpaces(Catalogue &catalogue);
void addCreation(Catalogue &catalogue);
void addDegenerateWorlds(Catalogue &catalogue);
void addDoubleJoints(Catalogue &catalogue);
void addFaults(Catalogue &catalogue);
void addFixedJoints(Catalogue &catalogue);
void addFloatEnvironment(Catalogue &catalogue);
void addFriction(Catalogue &catalogue);
void addGeomPairs(Catalogue &catalogue);
void addHinge2Joints(Catalogue &catalogue);
void addHingeJoints(Catalogue &catalogue);
void addJointFeedback(Catalogue &catalogue);
void addKinematicBodies(Catalogue &catalogue);
void addMessages(Catalogue &catalogue);
void addMotorJoints(Catalogue &catalogue);
void addMovedCallbacks(Catalogue &catalogue);
void addPoweredStops(Catalogue &catalogue);
void addPrismaticJoints(Catalogue &catalogue);
void addRandomStream(Catalogue &catalogue);
void addSeveralWorlds(Catalogue &catalogue);
void addSharedScenes(Catalogue &catalogue);
void addSliderJoints(Catalogue &catalogue);
void addTerrain(Catalogue &catalogue);
void addTransmissionJoints(Catalogue &catalogue);
void addUniversalJoints(Catalogue &catalogue);
void addUserGeomClass(Catalogue &catalogue);
void addUserThreading(Catalogue &catalogue);
void addWorldParameters(Catalogue &catalogue);

}  // namespace exactness
