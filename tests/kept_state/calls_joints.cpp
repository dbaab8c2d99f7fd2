// Recipes for the functions of objects.h that are for joints of all types.
#include "call_recipes.h"

namespace kept_state {

namespace {

// Returns a joint of a type of the scene, alternately; the types without rows of their own are included.
dJointID some(CallScene &s) {
    for (std::size_t i = 1; i < s.joints.size(); ++i) {
        const dJointID joint = s.joints[(s.turn + i) % s.joints.size()];
        if (joint != nullptr) return joint;
    }
    return nullptr;
}

void addCreators(CallRecipes &r) {
    const auto create = [&](const char *name, dJointID (*make)(dWorldID, dJointGroupID)) {
        r.push_back({name, [make](CallScene &s) {
                         const dJointID joint = s.adopt(make(s.world, nullptr));
                         const bool isPlane = dJointGetType(joint) == dJointTypePlane2D;
                         dJointAttach(joint, s.filler(2), isPlane ? nullptr : s.filler(3));
                     }});
    };
    create("dJointCreateBall", dJointCreateBall);
    create("dJointCreateHinge", dJointCreateHinge);
    create("dJointCreateSlider", dJointCreateSlider);
    create("dJointCreateUniversal", dJointCreateUniversal);
    create("dJointCreateHinge2", dJointCreateHinge2);
    create("dJointCreateFixed", dJointCreateFixed);
    create("dJointCreateNull", dJointCreateNull);
    create("dJointCreateAMotor", dJointCreateAMotor);
    create("dJointCreateLMotor", dJointCreateLMotor);
    create("dJointCreatePlane2D", dJointCreatePlane2D);
    create("dJointCreatePR", dJointCreatePR);
    create("dJointCreatePU", dJointCreatePU);
    create("dJointCreatePiston", dJointCreatePiston);
    create("dJointCreateDBall", dJointCreateDBall);
    create("dJointCreateDHinge", dJointCreateDHinge);
    create("dJointCreateTransmission", dJointCreateTransmission);
    r.push_back({"dJointCreateContact", [](CallScene &s) {
                     dContact contact{};
                     contact.surface.mu = 0.4;
                     contact.geom.normal[2] = 1;
                     contact.geom.depth = 0.01;
                     const dReal *place = dBodyGetPosition(s.body());
                     for (int i = 0; i < 3; ++i) contact.geom.pos[i] = place[i];
                     const dJointID joint =
                         dJointCreateContact(dBodyGetWorld(s.body()), s.contacts, &contact);
                     dJointAttach(joint, s.body(), nullptr);
                 }});
}

void addGroups(CallRecipes &r) {
    r.push_back({"dJointGroupCreate", [](CallScene &) { dJointGroupDestroy(dJointGroupCreate(0)); }});
    r.push_back({"dJointGroupDestroy", [](CallScene &s) {
                     const dJointGroupID group = dJointGroupCreate(0);
                     dJointAttach(dJointCreateBall(s.world, group), s.filler(5), s.filler(6));
                     dJointGroupDestroy(group);
                 }});
    r.push_back({"dJointGroupEmpty", [](CallScene &s) { dJointGroupEmpty(s.contacts); }});
    r.back().inStep = false;
}

}  // namespace

void addJointCalls(CallRecipes &recipes) {
    CallRecipes r;
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    addCreators(r);
    addGroups(r);
    r.push_back({"dJointDestroy", [](CallScene &s) {
                     const dJointID joint = some(s);
                     s.drop(joint);
                     dJointDestroy(joint);
                 }});
    r.back().amidStep = false;
    r.push_back({"dJointAttach", [](CallScene &s) { dJointAttach(some(s), s.filler(1), nullptr); },
                 [](CallScene &s) { dJointAttach(some(s), nullptr, nullptr); }});
    r.push_back({"dJointEnable", [](CallScene &s) { dJointEnable(some(s)); },
                 [](CallScene &s) { dJointDisable(some(s)); }});
    r.push_back({"dJointDisable", [](CallScene &s) { dJointDisable(some(s)); },
                 [](CallScene &s) { dJointEnable(some(s)); }});
    r.push_back({"dJointSetData", [](CallScene &s) { dJointSetData(some(s), &s); }});
    r.push_back({"dJointSetFeedback",
                 [](CallScene &s) {
                     static dJointFeedback feedback;
                     feedback = {};
                     dJointSetFeedback(some(s), &feedback);
                     dWorldQuickStep(s.world, 0.001);
                     s.tell(feedback.f1, 3);
                 },
                 [](CallScene &s) { dJointSetFeedback(some(s), nullptr); }});
    r.back().inLocked = false;
    ask("dJointGetNumBodies", [](CallScene &s) { s.tell(dJointGetNumBodies(some(s))); });
    ask("dJointIsEnabled", [](CallScene &s) { s.tell(dJointIsEnabled(some(s))); });
    ask("dJointGetData", [](CallScene &s) { s.tell(dJointGetData(some(s)) == nullptr); });
    ask("dJointGetType", [](CallScene &s) { s.tell(dJointGetType(some(s))); });
    ask("dJointGetBody", [](CallScene &s) { s.tell(static_cast<const void *>(dJointGetBody(some(s), 0))); });
    ask("dJointGetFeedback", [](CallScene &s) { s.tell(dJointGetFeedback(some(s)) == nullptr); });
    ask("dConnectingJoint", [](CallScene &s) {
        s.tell(static_cast<const void *>(dConnectingJoint(s.filler(37), s.filler(25))));
    });
    ask("dConnectingJointList", [](CallScene &s) {
        dJointID joints[20];
        s.tell(dConnectingJointList(s.filler(37), s.filler(25), joints));
    });
    ask("dAreConnected", [](CallScene &s) { s.tell(dAreConnected(s.filler(37), s.filler(25))); });
    ask("dAreConnectedExcluding",
        [](CallScene &s) { s.tell(dAreConnectedExcluding(s.filler(37), s.filler(25), dJointTypeContact)); });
    addJointTypeCalls(r);
    for (CallRecipe &recipe : r) {
        recipe.anySpace = true;
        recipes.push_back(std::move(recipe));
    }
}

}  // namespace kept_state
