// Recipes for the functions of objects.h that are for worlds.
#include "call_recipes.h"

#include <ode/threading_impl.h>

#include <cstdlib>

namespace kept_state {

namespace {

template <class Value>
struct Setting {
    const char *setter;
    void (*set)(dWorldID, Value);
    Value value, former;
};

template <class Value>
void addSetting(CallRecipes &r, const Setting<Value> &setting) {
    r.push_back({setting.setter, [setting](CallScene &s) { setting.set(s.world, setting.value); },
                 [setting](CallScene &s) { setting.set(s.world, setting.former); }});
}

template <class Value>
void addGetter(CallRecipes &r, const char *name, Value (*get)(dWorldID)) {
    r.push_back({name, [get](CallScene &s) { s.tell(get(s.world)); }, nullptr, true});
}

void addNumbers(CallRecipes &r) {
    const Setting<dReal> numbers[] = {
        {"dWorldSetERP", dWorldSetERP, 0.6, 0.3},
        {"dWorldSetCFM", dWorldSetCFM, 1e-2, 1e-5},
        {"dWorldSetQuickStepW", dWorldSetQuickStepW, 1.0, 1.3},
        {"dWorldSetContactMaxCorrectingVel", dWorldSetContactMaxCorrectingVel, 0.1, dInfinity},
        {"dWorldSetContactSurfaceLayer", dWorldSetContactSurfaceLayer, 0.01, 0},
        {"dWorldSetAutoDisableLinearThreshold", dWorldSetAutoDisableLinearThreshold, 10, 0.01},
        {"dWorldSetAutoDisableAngularThreshold", dWorldSetAutoDisableAngularThreshold, 10, 0.01},
        {"dWorldSetAutoDisableTime", dWorldSetAutoDisableTime, 0.01, 0},
        {"dWorldSetLinearDampingThreshold", dWorldSetLinearDampingThreshold, 0.001, 0.01},
        {"dWorldSetAngularDampingThreshold", dWorldSetAngularDampingThreshold, 0.001, 0.01},
        {"dWorldSetLinearDamping", dWorldSetLinearDamping, 0.2, 0},
        {"dWorldSetAngularDamping", dWorldSetAngularDamping, 0.2, 0},
        {"dWorldSetMaxAngularSpeed", dWorldSetMaxAngularSpeed, 0.1, dInfinity}};
    for (const auto &setting : numbers) addSetting(r, setting);
    const Setting<int> counts[] = {
        {"dWorldSetQuickStepNumIterations", dWorldSetQuickStepNumIterations, 7, 20},
        {"dWorldSetAutoDisableSteps", dWorldSetAutoDisableSteps, 1, 10},
        {"dWorldSetAutoDisableFlag", dWorldSetAutoDisableFlag, 1, 0}};
    for (const auto &setting : counts) addSetting(r, setting);
    const Setting<unsigned> sizes[] = {
        {"dWorldSetAutoDisableAverageSamplesCount", dWorldSetAutoDisableAverageSamplesCount, 4, 1},
        {"dWorldSetStepIslandsProcessingMaxThreadCount", dWorldSetStepIslandsProcessingMaxThreadCount, 1, 0}};
    for (const auto &setting : sizes) addSetting(r, setting);
}

void addGetters(CallRecipes &r) {
    addGetter(r, "dWorldGetERP", dWorldGetERP);
    addGetter(r, "dWorldGetCFM", dWorldGetCFM);
    addGetter(r, "dWorldGetQuickStepW", dWorldGetQuickStepW);
    addGetter(r, "dWorldGetContactMaxCorrectingVel", dWorldGetContactMaxCorrectingVel);
    addGetter(r, "dWorldGetContactSurfaceLayer", dWorldGetContactSurfaceLayer);
    addGetter(r, "dWorldGetAutoDisableLinearThreshold", dWorldGetAutoDisableLinearThreshold);
    addGetter(r, "dWorldGetAutoDisableAngularThreshold", dWorldGetAutoDisableAngularThreshold);
    addGetter(r, "dWorldGetAutoDisableTime", dWorldGetAutoDisableTime);
    addGetter(r, "dWorldGetLinearDampingThreshold", dWorldGetLinearDampingThreshold);
    addGetter(r, "dWorldGetAngularDampingThreshold", dWorldGetAngularDampingThreshold);
    addGetter(r, "dWorldGetLinearDamping", dWorldGetLinearDamping);
    addGetter(r, "dWorldGetAngularDamping", dWorldGetAngularDamping);
    addGetter(r, "dWorldGetMaxAngularSpeed", dWorldGetMaxAngularSpeed);
    addGetter(r, "dWorldGetQuickStepNumIterations", dWorldGetQuickStepNumIterations);
    addGetter(r, "dWorldGetAutoDisableSteps", dWorldGetAutoDisableSteps);
    addGetter(r, "dWorldGetAutoDisableFlag", dWorldGetAutoDisableFlag);
    addGetter(r, "dWorldGetAutoDisableAverageSamplesCount", dWorldGetAutoDisableAverageSamplesCount);
    addGetter(r, "dWorldGetStepIslandsProcessingMaxThreadCount",
              dWorldGetStepIslandsProcessingMaxThreadCount);
    r.push_back(
        {"dWorldGetData", [](CallScene &s) { s.tell(dWorldGetData(s.world) == nullptr); }, nullptr, true});
    r.push_back({"dWorldGetGravity",
                 [](CallScene &s) {
                     dVector3 gravity;
                     dWorldGetGravity(s.world, gravity);
                     s.tell(gravity, 3);
                 },
                 nullptr, true});
    r.push_back({"dWorldImpulseToForce",
                 [](CallScene &s) {
                     dVector3 force;
                     dWorldImpulseToForce(s.world, 0.01, 1, 2, 3, force);
                     s.tell(force, 3);
                 },
                 nullptr, true});
}

void destroySecond(CallScene &s) {
    if (s.second == nullptr) return;
    std::vector<dBodyID> left;
    for (const dBodyID body : s.bodies)
        if (dBodyGetWorld(body) != s.second) left.push_back(body);
    s.bodies = left;
    dWorldDestroy(s.second);
    s.second = nullptr;
}

void *allocate(dsizeint size) { return std::malloc(size); }
void *reallocate(void *block, dsizeint, dsizeint size) { return std::realloc(block, size); }
void release(void *block, dsizeint) { std::free(block); }

void addMemory(CallRecipes &r) {
    r.push_back({"dWorldUseSharedWorkingMemory",
                 [](CallScene &s) { s.tell(dWorldUseSharedWorkingMemory(s.world, s.second)); },
                 [](CallScene &s) { s.tell(dWorldUseSharedWorkingMemory(s.world, nullptr)); }});
    r.push_back({"dWorldCleanupWorkingMemory", [](CallScene &s) { dWorldCleanupWorkingMemory(s.world); }});
    r.back().inStep = false;
    r.push_back({"dWorldSetStepMemoryReservationPolicy",
                 [](CallScene &s) {
                     const dWorldStepReserveInfo policy{sizeof policy, 2.0f, 1024};
                     s.tell(dWorldSetStepMemoryReservationPolicy(s.world, &policy));
                 },
                 [](CallScene &s) { s.tell(dWorldSetStepMemoryReservationPolicy(s.world, nullptr)); }});
    r.push_back(
        {"dWorldSetStepMemoryManager",
         [](CallScene &s) {
             const dWorldStepMemoryFunctionsInfo functions{sizeof functions, allocate, reallocate, release};
             s.tell(dWorldSetStepMemoryManager(s.world, &functions));
         },
         [](CallScene &s) { s.tell(dWorldSetStepMemoryManager(s.world, nullptr)); }});
}

void addThreading(CallRecipes &r) {
    const auto lend = [](CallScene &s) {
        static const dThreadingImplementationID self = dThreadingAllocateSelfThreadedImplementation();
        dWorldSetStepThreadingImplementation(s.world, dThreadingImplementationGetFunctions(self), self);
    };
    r.push_back({"dWorldSetStepThreadingImplementation", lend,
                 [](CallScene &s) { dWorldSetStepThreadingImplementation(s.world, nullptr, nullptr); }});
    r.back().inStep = false;
}

}  // namespace

void addWorldCalls(CallRecipes &recipes) {
    CallRecipes r;
    addNumbers(r);
    addGetters(r);
    addMemory(r);
    addThreading(r);
    r.push_back({"dWorldSetGravity", [](CallScene &s) { dWorldSetGravity(s.world, 1, 0, -3); },
                 [](CallScene &s) { dWorldSetGravity(s.world, 0, 0, -9.81); }});
    r.push_back({"dWorldSetDamping", [](CallScene &s) { dWorldSetDamping(s.world, 0.1, 0.2); },
                 [](CallScene &s) { dWorldSetDamping(s.world, 0, 0); }});
    r.push_back({"dWorldSetData", [](CallScene &s) { dWorldSetData(s.world, &s); }});
    r.push_back({"dWorldCreate", [](CallScene &) { dWorldDestroy(dWorldCreate()); }});
    r.push_back({"dWorldDestroy", destroySecond});
    r.back().inLocked = r.back().inStep = false;
    r.push_back({"dWorldStep", [](CallScene &s) { dWorldStep(s.world, 0.005); }});
    r.back().amidStep = false;
    r.push_back({"dWorldQuickStep", [](CallScene &s) { dWorldQuickStep(s.world, 0.005); }});
    r.back().amidStep = false;
    for (CallRecipe &recipe : r) {
        recipe.anySpace = true;
        recipes.push_back(std::move(recipe));
    }
}

}  // namespace kept_state
