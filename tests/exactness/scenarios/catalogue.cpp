#include "catalogue.h"

#include "additions.h"

namespace exactness {

const Catalogue &catalogue() {
    static const Catalogue scenarios = [] {
        Catalogue all;
        addAutoDisable(all);
        addBallJoints(all);
        addBodyMotion(all);
        addCollisionSpaces(all);
        addCreation(all);
        addDegenerateWorlds(all);
        addDoubleJoints(all);
        addFaults(all);
        addFixedJoints(all);
        addFloatEnvironment(all);
        addFriction(all);
        addGeomPairs(all);
        addHinge2Joints(all);
        addHingeJoints(all);
        addJointFeedback(all);
        addKinematicBodies(all);
        addMessages(all);
        addMotorJoints(all);
        addMovedCallbacks(all);
        addPoweredStops(all);
        addPrismaticJoints(all);
        addRandomStream(all);
        addSeveralWorlds(all);
        addSharedScenes(all);
        addSliderJoints(all);
        addTerrain(all);
        addTransmissionJoints(all);
        addUniversalJoints(all);
        addUserGeomClass(all);
        addUserThreading(all);
        addWorldParameters(all);
        return all;
    }();
    return scenarios;
}

}  // namespace exactness
