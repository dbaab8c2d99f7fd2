#include "call_contexts.h"

#include "call_shapes.h"
#include "thorough.h"
#include "user_code.h"

#include <cstdlib>
#include <thread>

#include <pthread.h>

namespace kept_state {

namespace {

constexpr When kFirst = When::colliderGetter, kLast = When::last;

bool isInUserCode(When when) {
    return when == When::colliderGetter || (when >= When::collider && when <= When::threadEnd);
}

// Upstream continues, and what the call may access exists.
bool isPossible(const CallRecipe &recipe, When when) {
    if (isInUserCode(when) && !(recipe.inLocked && recipe.inUserCode)) return false;
    switch (when) {
        case When::undone:
            return recipe.undo != nullptr;
        case When::near:
            return recipe.inLocked;
        case When::moved:
            return recipe.inStep;
        case When::messageHandler:
            return recipe.inStep && recipe.amidStep;
        case When::stepMemory:  // for as many bodies and joints as upstream has counted
            return recipe.inStep && recipe.amidStep && (recipe.readsOnly || !recipe.anySpace);
        case When::boxFunction:
        case When::triangleCallback:
        case When::heightCallback:
            return recipe.inCollision;
        default:
            return true;
    }
}

bool isByTurns(const CallRecipe &recipe, When when, int number, SpaceKind kind) {
    const int sum = number + static_cast<int>(when) + static_cast<int>(kind);
    if (isInUserCode(when)) {
        if ((recipe.readsOnly || recipe.anySpace) && (number + static_cast<int>(when)) % 4 != 0) return false;
        return (when != When::colliderGetter && recipe.everySpace) || sum % 4 == 0;
    }
    if (recipe.readsOnly && when != When::asked && when != When::near) return false;
    return recipe.everySpace || sum % (recipe.anySpace ? 4 : 2) == 0;
}

Place placeFor(When when, Place place) {
    switch (when) {
        case When::nearOther:
        case When::spaceDestroyed:
            return Place::other;
        case When::colliderGetter:
            return Place::root;
        default:
            return place;
    }
}

// --- code of the program's ------------------------------------------------------------------------------

bool anyTriangle(dGeomID, dGeomID, int) {
    reached(UserCode::triangleCallback);
    return true;
}

int takeTriangle(dGeomID one, dGeomID other, int triangle) { return anyTriangle(one, other, triangle); }

int takeHit(dGeomID one, dGeomID other, int triangle, dReal, dReal) {
    return anyTriangle(one, other, triangle);
}

dReal heightOf(void *, int x, int z) {
    reached(UserCode::heightCallback);
    return 0.1 * ((5 * x + 7 * z) % 5);
}

void *allocate(dsizeint size) {
    reached(UserCode::allocator);
    return std::malloc(size);
}

void *allocateForStep(dsizeint size) {
    reached(UserCode::stepMemory);
    return std::malloc(size);
}

void *reallocate(void *block, dsizeint, dsizeint size) { return std::realloc(block, size); }
void release(void *block, dsizeint) { std::free(block); }

void setMeshCallbacks(CallScene &scene) {
    for (const Place place : allPlaces)
        for (const dGeomID mesh : {scene.setAt(place).mesh, scene.setAt(place).terrain}) {
            dGeomTriMeshSetCallback(mesh, takeTriangle);
            dGeomTriMeshSetRayCallback(mesh, takeHit);
        }
}

void setHeightCallbacks(CallScene &scene) {
    for (const Place place : allPlaces) {
        const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildCallback(data, nullptr, heightOf, 3, 3, 5, 5, 1, 0, 0.2, 0);
        dGeomHeightfieldDataSetBounds(data, -0.5, 1.5);
        dGeomHeightfieldSetHeightfieldData(scene.setAt(place).heights, data);
    }
}

// A body that three motors drive at different speeds: the exact step has no solution, and says so.
void addContradiction(CallScene &scene) {
    dMass mass;
    dMassSetSphereTotal(&mass, 1, 0.2);
    const dBodyID body = scene.adopt(dBodyCreate(scene.world));
    dBodySetMass(body, &mass);
    dBodySetPosition(body, 6, 6, 6);
    for (int i = 0; i < 3; ++i) {
        const dJointID motor = scene.adopt(dJointCreateLMotor(scene.world, nullptr));
        dJointAttach(motor, body, nullptr);
        dJointSetLMotorNumAxes(motor, 3);
        for (int axis = 0; axis < 3; ++axis) {
            dJointSetLMotorAxis(motor, axis, 0, axis == 0, axis == 1, axis == 2);
            dJointSetLMotorParam(motor, dParamCFM + dParamGroup * axis, 0);
            dJointSetLMotorParam(motor, dParamFMax + dParamGroup * axis, 0.7 + 0.31 * i);
            dJointSetLMotorParam(motor, dParamVel + dParamGroup * axis, 0.1 * i - 0.2);
        }
    }
}

// The destructor of a pthread key is the last code of the program's that a thread runs.
void callAtThreadEnd(CallScene &scene, const std::function<void()> &call) {
    static pthread_key_t key;
    static const std::function<void()> *atEnd;
    static const int made = pthread_key_create(&key, [](void *) { (*atEnd)(); });
    atEnd = &call;
    std::thread([&] {
        dAllocateODEDataForThread(dAllocateMaskAll);
        pthread_setspecific(key, &scene);
        dContactGeom contacts[4];
        scene.tell(made + dCollide(scene.set().sphere, scene.set().terrain, 4, contacts, sizeof contacts[0]));
    }).join();
}

// Geoms of the place that code of the program's belongs to are asked again.
void disturb(CallScene &scene) {
    const dReal *place = dGeomGetPosition(scene.set().custom);
    dGeomSetPosition(scene.set().custom, place[0], place[1], place[2]);
}

void frameOrBox(CallScene &scene) {
    dReal box[6];
    if (scene.place == Place::nowhere) dGeomGetAABB(scene.set().custom, box);
    scene.frame();
}

void destroyCustom(CallScene &scene) {
    const dGeomID geom = scene.set().custom;
    scene.drop(geom);
    dGeomDestroy(geom);
}

void makeCallIn(CallScene &scene, When when, const std::function<void()> &call) {
    switch (when) {
        case When::colliderGetter:
            callIn(UserCode::colliderGetter, call);
            for (const Place place : allPlaces) dGeomEnable(scene.setAt(place).custom);
            return scene.frame();
        case When::collider:
            callIn(UserCode::collider, call);
            return scene.frame();
        case When::boxFunction:
            disturb(scene);
            callIn(UserCode::boxFunction, call);
            return frameOrBox(scene);
        case When::boxTest:
            callIn(UserCode::boxTest, call);
            return scene.frame();
        case When::destructor:
            callIn(UserCode::destructor, call);
            return destroyCustom(scene);
        case When::spaceDestroyed:
            callIn(UserCode::destructor, call);
            return scene.destroyRoot();
        case When::triangleCallback:
            setMeshCallbacks(scene);
            callIn(UserCode::triangleCallback, call);
            return scene.frame();
        case When::heightCallback:
            setHeightCallbacks(scene);
            callIn(UserCode::heightCallback, call);
            return scene.frame();
        case When::messageHandler:
            callIn(UserCode::messageHandler, call);
            return scene.frame();
        case When::debugHandler:
            callIn(UserCode::debugHandler, call);
            scene.inNearCallback = [&scene] {
                dSpaceRemove(scene.setAt(Place::root).space, scene.setAt(Place::root).slab);
            };
            return scene.frame();
        case When::allocator:
            dSetAllocHandler(allocate);
            callIn(UserCode::allocator, call);
            if (scene.turn % 2 == 0)
                scene.adopt(dBodyCreate(scene.world));
            else
                scene.adopt(dCreateSphere(scene.set().space, 0.3));
            return;
        case When::stepMemory: {
            const dWorldStepMemoryFunctionsInfo functions{sizeof functions, allocateForStep, reallocate, release};
            dWorldCleanupWorkingMemory(scene.world);
            dWorldSetStepMemoryManager(scene.world, &functions);
            callIn(UserCode::stepMemory, call);
            return scene.frame();
        }
        default:
            return callAtThreadEnd(scene, call);
    }
}

}  // namespace

const char *nameOf(When when) {
    static const char *const names[] = {
        "getter",       "between",  "asked",      "before_step",     "near",
        "near_other",   "moved",    "twice",      "undone",          "collider",
        "box_function", "box_test", "destructor", "space_destroyed", "triangle",
        "height",       "message",  "debug",      "allocator",       "step_memory",
        "thread_end",   "last"};
    return names[static_cast<int>(when)];
}

std::string Case::name() const {
    return recipe.function + '/' + kept_state::nameOf(when) + '/' + kept_state::nameOf(kind) + '/' +
           kept_state::nameOf(place) + '/' + std::to_string(turn);
}

void forEachCase(const CallRecipe &recipe, int number, const std::function<void(const Case &)> &visit) {
    const bool thorough = exactness::isThorough();
    for (int w = static_cast<int>(kFirst); w <= static_cast<int>(kLast); ++w) {
        const auto when = static_cast<When>(w);
        if (!isPossible(recipe, when)) continue;
        for (const SpaceKind kind : allSpaceKinds) {
            const int k = static_cast<int>(kind);
            // A getter is asked once in a process, thorough or not.
            if ((!thorough || when == When::colliderGetter) && !isByTurns(recipe, when, number, kind)) continue;
            for (int p = 0; p < 4; ++p) {
                if ((!thorough || when == When::colliderGetter) && (p + number + w + k) % 4 != 0) continue;
                visit(Case{recipe, when, kind, placeFor(when, allPlaces[p]), number + 5 * w + 3 * k + 7 * p});
            }
        }
    }
}

void prepare(CallScene &scene, const Case &c) {
    if (c.when == When::colliderGetter)
        for (const Place place : allPlaces) dGeomDisable(scene.setAt(place).custom);
    if (c.when == When::messageHandler) addContradiction(scene);
    // Few, as libode8's exact steps are slow.
    scene.stepsExactly = c.when == When::messageHandler || c.turn % (exactness::isThorough() ? 8 : 16) == 0;
}

void makeCall(CallScene &scene, const Case &c) {
    // Without references to what is gone when code of the program's runs only later.
    const auto call = [&scene, &c] { c.recipe.call(scene); };
    const auto attempt = [&scene, call] { scene.attempt(call); };
    switch (c.when) {
        case When::between:
            return attempt();
        case When::asked:
        case When::last:
            scene.askBoxes();
            return attempt();
        case When::beforeStep:
            scene.collide();
            attempt();
            return scene.step();
        case When::near:
        case When::nearOther:
            scene.inNearCallback = call;
            return scene.frame();
        case When::moved:
            scene.inMovedCallback = call;
            return scene.frame();
        case When::twice:
            attempt();
            return attempt();
        case When::undone:
            attempt();
            scene.attempt([&] { c.recipe.undo(scene); });
            return;
        default:
            return makeCallIn(scene, c.when, attempt);
    }
}

}  // namespace kept_state
