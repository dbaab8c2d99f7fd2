// Recipes for the functions of objects.h that are for bodies.
#include "call_recipes.h"

namespace kept_state {

namespace {

void addVectors(CallRecipes &r) {
    using Set3 = void (*)(dBodyID, dReal, dReal, dReal);
    const auto set3 = [&](const char *name, Set3 set, dReal x, dReal y, dReal z, bool touchesSpaces) {
        r.push_back({name, [=](CallScene &s) { set(s.body(), x, y, z); },
                     [=](CallScene &s) { set(s.body(), 0, 0, 1); }});
        r.back().anySpace = !touchesSpaces;
    };
    set3("dBodySetPosition", dBodySetPosition, 0.5, 0.6, 0.4, true);
    set3("dBodySetLinearVel", dBodySetLinearVel, 1, 0.5, 2, false);
    set3("dBodySetAngularVel", dBodySetAngularVel, 1, 0.5, 2, false);
    set3("dBodyAddForce", dBodyAddForce, 10, 5, 20, false);
    set3("dBodyAddTorque", dBodyAddTorque, 1, 0.5, 2, false);
    set3("dBodyAddRelForce", dBodyAddRelForce, 10, 5, 20, false);
    set3("dBodyAddRelTorque", dBodyAddRelTorque, 1, 0.5, 2, false);
    set3("dBodySetForce", dBodySetForce, 10, 5, 20, false);
    set3("dBodySetTorque", dBodySetTorque, 1, 0.5, 2, false);
    set3("dBodySetFiniteRotationAxis", dBodySetFiniteRotationAxis, 0, 1, 0, false);
    using Set6 = void (*)(dBodyID, dReal, dReal, dReal, dReal, dReal, dReal);
    const auto set6 = [&](const char *name, Set6 set) {
        r.push_back({name, [=](CallScene &s) { set(s.body(), 10, 5, 20, 0.1, 0.2, 0.3); }});
        r.back().anySpace = true;
    };
    set6("dBodyAddForceAtPos", dBodyAddForceAtPos);
    set6("dBodyAddForceAtRelPos", dBodyAddForceAtRelPos);
    set6("dBodyAddRelForceAtPos", dBodyAddRelForceAtPos);
    set6("dBodyAddRelForceAtRelPos", dBodyAddRelForceAtRelPos);
    r.push_back({"dBodySetRotation", [](CallScene &s) {
                     const dMatrix3 quarter{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
                     dBodySetRotation(s.body(), quarter);
                 }});
    r.push_back({"dBodySetQuaternion", [](CallScene &s) {
                     const dQuaternion eighth{0.92387953251128674, 0.38268343236508978, 0, 0};
                     dBodySetQuaternion(s.body(), eighth);
                 }});
}

void addNumbers(CallRecipes &r) {
    const auto add = [&](const char *name, auto set, auto value, auto former) {
        r.push_back({name, [=](CallScene &s) { set(s.body(), value); },
                     [=](CallScene &s) { set(s.body(), former); }});
        r.back().anySpace = true;
    };
    add("dBodySetAutoDisableLinearThreshold", dBodySetAutoDisableLinearThreshold, 10.0, 0.01);
    add("dBodySetAutoDisableAngularThreshold", dBodySetAutoDisableAngularThreshold, 10.0, 0.01);
    add("dBodySetAutoDisableAverageSamplesCount", dBodySetAutoDisableAverageSamplesCount, 4u, 1u);
    add("dBodySetAutoDisableSteps", dBodySetAutoDisableSteps, 1, 10);
    add("dBodySetAutoDisableTime", dBodySetAutoDisableTime, 0.01, 0.0);
    add("dBodySetAutoDisableFlag", dBodySetAutoDisableFlag, 1, 0);
    add("dBodySetFiniteRotationMode", dBodySetFiniteRotationMode, 1, 0);
    add("dBodySetGravityMode", dBodySetGravityMode, 0, 1);
    add("dBodySetGyroscopicMode", dBodySetGyroscopicMode, 0, 1);
    add("dBodySetLinearDamping", dBodySetLinearDamping, 0.2, 0.0);
    add("dBodySetAngularDamping", dBodySetAngularDamping, 0.2, 0.0);
    add("dBodySetLinearDampingThreshold", dBodySetLinearDampingThreshold, 0.001, 0.01);
    add("dBodySetAngularDampingThreshold", dBodySetAngularDampingThreshold, 0.001, 0.01);
    add("dBodySetMaxAngularSpeed", dBodySetMaxAngularSpeed, 0.1, dInfinity);
    add("dBodySetData", dBodySetData, static_cast<void *>(nullptr), static_cast<void *>(nullptr));
    add("dBodySetMovedCallback", dBodySetMovedCallback, static_cast<void (*)(dBodyID)>(nullptr),
        static_cast<void (*)(dBodyID)>([](dBodyID) {}));
    const auto act = [&](const char *name, void (*call)(dBodyID), void (*undo)(dBodyID)) {
        r.push_back({name, [=](CallScene &s) { call(s.body()); }, nullptr});
        if (undo != nullptr) r.back().undo = [=](CallScene &s) { undo(s.body()); };
        r.back().anySpace = true;
    };
    act("dBodySetAutoDisableDefaults", dBodySetAutoDisableDefaults, nullptr);
    act("dBodySetDampingDefaults", dBodySetDampingDefaults, nullptr);
    act("dBodySetDynamic", dBodySetDynamic, dBodySetKinematic);
    act("dBodySetKinematic", dBodySetKinematic, dBodySetDynamic);
    act("dBodyEnable", dBodyEnable, dBodyDisable);
    act("dBodyDisable", dBodyDisable, dBodyEnable);
    r.push_back({"dBodySetDamping", [](CallScene &s) { dBodySetDamping(s.body(), 0.1, 0.2); }});
    r.back().anySpace = true;
    r.push_back({"dBodySetMass", [](CallScene &s) {
                     dMass mass;
                     dMassSetBoxTotal(&mass, 3, 0.4, 0.3, 0.2);
                     dBodySetMass(s.body(), &mass);
                 }});
    r.back().anySpace = true;
}

void addGetters(CallRecipes &r) {
    const auto number = [&](const char *name, auto get) {
        r.push_back({name, [get](CallScene &s) { s.tell(get(s.body())); }, nullptr, true});
    };
    number("dBodyGetAutoDisableLinearThreshold", dBodyGetAutoDisableLinearThreshold);
    number("dBodyGetAutoDisableAngularThreshold", dBodyGetAutoDisableAngularThreshold);
    number("dBodyGetAutoDisableAverageSamplesCount", dBodyGetAutoDisableAverageSamplesCount);
    number("dBodyGetAutoDisableSteps", dBodyGetAutoDisableSteps);
    number("dBodyGetAutoDisableTime", dBodyGetAutoDisableTime);
    number("dBodyGetAutoDisableFlag", dBodyGetAutoDisableFlag);
    number("dBodyGetFiniteRotationMode", dBodyGetFiniteRotationMode);
    number("dBodyGetNumJoints", dBodyGetNumJoints);
    number("dBodyIsKinematic", dBodyIsKinematic);
    number("dBodyIsEnabled", dBodyIsEnabled);
    number("dBodyGetGravityMode", dBodyGetGravityMode);
    number("dBodyGetLinearDamping", dBodyGetLinearDamping);
    number("dBodyGetAngularDamping", dBodyGetAngularDamping);
    number("dBodyGetLinearDampingThreshold", dBodyGetLinearDampingThreshold);
    number("dBodyGetAngularDampingThreshold", dBodyGetAngularDampingThreshold);
    number("dBodyGetMaxAngularSpeed", dBodyGetMaxAngularSpeed);
    number("dBodyGetGyroscopicMode", dBodyGetGyroscopicMode);
    const auto vector = [&](const char *name, const dReal *(*get)(dBodyID), int count) {
        r.push_back({name, [=](CallScene &s) { s.tell(get(s.body()), count); }, nullptr, true});
    };
    vector("dBodyGetPosition", dBodyGetPosition, 3);
    vector("dBodyGetRotation", dBodyGetRotation, 3);
    vector("dBodyGetQuaternion", dBodyGetQuaternion, 4);
    vector("dBodyGetLinearVel", dBodyGetLinearVel, 3);
    vector("dBodyGetAngularVel", dBodyGetAngularVel, 3);
    vector("dBodyGetForce", dBodyGetForce, 3);
    vector("dBodyGetTorque", dBodyGetTorque, 3);
    const auto copy = [&](const char *name, void (*get)(dBodyID, dReal *), int count) {
        r.push_back({name,
                     [=](CallScene &s) {
                         dReal values[12]{};
                         get(s.body(), values);
                         s.tell(values, count);
                     },
                     nullptr, true});
    };
    copy("dBodyCopyPosition", dBodyCopyPosition, 3);
    copy("dBodyCopyRotation", dBodyCopyRotation, 3);
    copy("dBodyCopyQuaternion", dBodyCopyQuaternion, 4);
    copy("dBodyGetFiniteRotationAxis", dBodyGetFiniteRotationAxis, 3);
    const auto point = [&](const char *name, void (*get)(dBodyID, dReal, dReal, dReal, dReal *)) {
        r.push_back({name,
                     [=](CallScene &s) {
                         dVector3 result;
                         get(s.body(), 0.1, 0.2, 0.3, result);
                         s.tell(result, 3);
                     },
                     nullptr, true});
    };
    point("dBodyGetRelPointPos", dBodyGetRelPointPos);
    point("dBodyGetRelPointVel", dBodyGetRelPointVel);
    point("dBodyGetPointVel", dBodyGetPointVel);
    point("dBodyGetPosRelPoint", dBodyGetPosRelPoint);
    point("dBodyVectorToWorld", dBodyVectorToWorld);
    point("dBodyVectorFromWorld", dBodyVectorFromWorld);
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    ask("dBodyGetWorld", [](CallScene &s) { s.tell(static_cast<const void *>(dBodyGetWorld(s.body()))); });
    ask("dBodyGetData", [](CallScene &s) { s.tell(dBodyGetData(s.body()) == nullptr); });
    ask("dBodyGetJoint", [](CallScene &s) {
        const dBodyID body = s.filler(37);
        if (dBodyGetNumJoints(body) > 0) s.tell(dJointGetType(dBodyGetJoint(body, 0)));
    });
    ask("dBodyGetFirstGeom",
        [](CallScene &s) { s.tell(static_cast<const void *>(dBodyGetFirstGeom(s.body()))); });
    ask("dBodyGetNextGeom",
        [](CallScene &s) { s.tell(static_cast<const void *>(dBodyGetNextGeom(s.carried()))); });
    ask("dBodyGetMass", [](CallScene &s) {
        dMass mass;
        dBodyGetMass(s.body(), &mass);
        s.tell(mass.mass);
    });
    for (CallRecipe &recipe : r)
        if (recipe.readsOnly) recipe.anySpace = true;
}

}  // namespace

void addBodyCalls(CallRecipes &recipes) {
    CallRecipes r;
    addVectors(r);
    addNumbers(r);
    addGetters(r);
    r.push_back({"dBodyCreate", [](CallScene &s) {
                     const dBodyID body = s.adopt(dBodyCreate(s.world));
                     dBodySetPosition(body, 0.4, 0.4, 0.4);
                     dGeomSetBody(s.set().slab, body);
                 }});
    r.back().amidStep = false;
    r.push_back({"dBodyDestroy", [](CallScene &s) { dBodyDestroy(s.takeBody()); }});
    r.back().inStep = false;
    recipes.insert(recipes.end(), r.begin(), r.end());
}

}  // namespace kept_state
