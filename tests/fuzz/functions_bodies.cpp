// Functions that scripts call: those for bodies.
#include "by_hand.h"

namespace fuzz {

void addBodyFunctions(std::vector<Function> &all) {
    FUZZ_TYPED(dBodyAddForce);
    FUZZ_TYPED(dBodyAddForceAtPos);
    FUZZ_TYPED(dBodyAddForceAtRelPos);
    FUZZ_TYPED(dBodyAddRelForce);
    FUZZ_TYPED(dBodyAddRelForceAtPos);
    FUZZ_TYPED(dBodyAddRelForceAtRelPos);
    FUZZ_TYPED(dBodyAddRelTorque);
    FUZZ_TYPED(dBodyAddTorque);
    FUZZ_TYPED(dBodyCopyPosition);
    FUZZ_TYPED(dBodyCopyQuaternion);
    FUZZ_TYPED(dBodyCopyRotation);
    FUZZ_MAKER(dBodyCreate);
    FUZZ_TYPED(dBodyDisable);
    FUZZ_TYPED(dBodyEnable);
    FUZZ_TYPED(dBodyGetAngularDamping);
    FUZZ_TYPED(dBodyGetAngularDampingThreshold);
    FUZZ_TYPED(dBodyGetAngularVel);
    FUZZ_TYPED(dBodyGetAutoDisableAngularThreshold);
    FUZZ_TYPED(dBodyGetAutoDisableAverageSamplesCount);
    FUZZ_TYPED(dBodyGetAutoDisableFlag);
    FUZZ_TYPED(dBodyGetAutoDisableLinearThreshold);
    FUZZ_TYPED(dBodyGetAutoDisableSteps);
    FUZZ_TYPED(dBodyGetAutoDisableTime);
    FUZZ_TYPED(dBodyGetFiniteRotationAxis);
    FUZZ_TYPED(dBodyGetFiniteRotationMode);
    FUZZ_TYPED(dBodyGetFirstGeom);
    FUZZ_TYPED(dBodyGetForce);
    FUZZ_TYPED(dBodyGetGravityMode);
    FUZZ_TYPED(dBodyGetGyroscopicMode);
    FUZZ_TYPED(dBodyGetJoint);
    FUZZ_TYPED(dBodyGetLinearDamping);
    FUZZ_TYPED(dBodyGetLinearDampingThreshold);
    FUZZ_TYPED(dBodyGetLinearVel);
    FUZZ_TYPED(dBodyGetMaxAngularSpeed);
    FUZZ_TYPED(dBodyGetNextGeom);
    FUZZ_TYPED(dBodyGetNumJoints);
    FUZZ_TYPED(dBodyGetPointVel);
    FUZZ_TYPED(dBodyGetPosRelPoint);
    FUZZ_TYPED(dBodyGetPosition);
    FUZZ_TYPED(dBodyGetQuaternion);
    FUZZ_TYPED(dBodyGetRelPointPos);
    FUZZ_TYPED(dBodyGetRelPointVel);
    FUZZ_TYPED(dBodyGetRotation);
    FUZZ_TYPED(dBodyGetTorque);
    FUZZ_TYPED(dBodyGetWorld);
    FUZZ_TYPED(dBodyIsEnabled);
    FUZZ_TYPED(dBodyIsKinematic);
    FUZZ_TYPED(dBodySetAngularDamping);
    FUZZ_TYPED(dBodySetAngularDampingThreshold);
    FUZZ_TYPED(dBodySetAngularVel);
    FUZZ_TYPED(dBodySetAutoDisableAngularThreshold);
    FUZZ_TYPED(dBodySetAutoDisableAverageSamplesCount);
    FUZZ_TYPED(dBodySetAutoDisableFlag);
    FUZZ_TYPED(dBodySetAutoDisableLinearThreshold);
    FUZZ_TYPED(dBodySetAutoDisableSteps);
    FUZZ_TYPED(dBodySetAutoDisableTime);
    FUZZ_TYPED(dBodySetDamping);
    FUZZ_TYPED(dBodySetDampingDefaults);
    FUZZ_TYPED(dBodySetDynamic);
    FUZZ_TYPED(dBodySetFiniteRotationAxis);
    FUZZ_TYPED(dBodySetFiniteRotationMode);
    FUZZ_TYPED(dBodySetForce);
    FUZZ_TYPED(dBodySetGravityMode);
    FUZZ_TYPED(dBodySetGyroscopicMode);
    FUZZ_TYPED(dBodySetKinematic);
    FUZZ_TYPED(dBodySetLinearDamping);
    FUZZ_TYPED(dBodySetLinearDampingThreshold);
    FUZZ_TYPED(dBodySetLinearVel);
    FUZZ_TYPED(dBodySetMaxAngularSpeed);
    FUZZ_TYPED(dBodySetPosition);
    FUZZ_TYPED(dBodySetQuaternion);
    FUZZ_TYPED(dBodySetRotation);
    FUZZ_TYPED(dBodySetTorque);
    FUZZ_TYPED(dBodyVectorFromWorld);
    FUZZ_TYPED(dBodyVectorToWorld);

    byHand(all, "dBodyDestroy", {object(ObjectKind::body)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto body = get<dBodyID>(player, arguments[0]);
        if (body == nullptr) return false;
        player.objects.forget(ObjectKind::body, body);
        dBodyDestroy(body);
        return true;
    });
    // The mass is that of a box.
    byHand(all, "dBodySetMass",
           {object(ObjectKind::body), number(Meaning::size), number(Meaning::size), number(Meaning::size), number(Meaning::size)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto body = get<dBodyID>(player, arguments[0]);
               if (body == nullptr) return false;
               dMass mass;
               dMassSetBoxTotal(&mass, real(arguments[1]), real(arguments[2]), real(arguments[3]), real(arguments[4]));
               dBodySetMass(body, &mass);
               return true;
           });
    byHand(all, "dBodyGetMass", {object(ObjectKind::body)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto body = get<dBodyID>(player, arguments[0]);
        if (body == nullptr) return false;
        dMass mass;
        dBodyGetMass(body, &mass);
        player.tell("mass", &mass.mass, 1);
        player.tell("inertia", mass.I, 12);
        return true;
    }, 1);
    addData<dBodyID>(all, ObjectKind::body, "dBodySetData", dBodySetData, "dBodyGetData", dBodyGetData);
    byHand(all, "dBodySetMovedCallback", {object(ObjectKind::body), number(Meaning::flag)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto body = get<dBodyID>(player, arguments[0]);
               if (body == nullptr) return false;
               dBodySetMovedCallback(body, whole(arguments[1]) != 0 ? &Player::moved : nullptr);
               return true;
           });
}

}  // namespace fuzz
