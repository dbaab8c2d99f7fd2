// Functions that scripts call: those by which a program gives ODE its own memory, handlers, colliders and threads.
#include "by_hand.h"
#include "only_ours.h"

#include "contact_half_way.h"

#include <cstdlib>
#include <vector>

namespace fuzz {

namespace {

// --- memory: what is taken from one allocator is given back to the other, so both are malloc ---------------

void *takeMemory(std::size_t size) { return std::malloc(size); }
void *changeMemory(void *memory, std::size_t, std::size_t size) { return std::realloc(memory, size); }
void giveMemoryBack(void *memory, std::size_t) { std::free(memory); }
void *keepMemory(void *memory, std::size_t, std::size_t) { return memory; }

void addMemory(std::vector<Function> &all) {
    const auto addSwitch = [&](const char *name, auto set) {
        byHand(all, name, {number(Meaning::flag)}, [set](Player &, const Arguments &arguments, Reference &) {
            set(whole(arguments[0]) != 0);
            return true;
        }, 1);
    };
    addSwitch("dSetAllocHandler", [](bool on) { dSetAllocHandler(on ? takeMemory : nullptr); });
    addSwitch("dSetReallocHandler", [](bool on) { dSetReallocHandler(on ? changeMemory : nullptr); });
    addSwitch("dSetFreeHandler", [](bool on) { dSetFreeHandler(on ? giveMemoryBack : nullptr); });
    // It is not undone: upstream would use the functions of a manager that it has deleted.
    byHand(all, "dWorldSetStepMemoryManager", {object(ObjectKind::world)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto world = get<dWorldID>(player, arguments[0]);
        if (world == nullptr) return false;
        const dWorldStepMemoryFunctionsInfo functions{sizeof functions, takeMemory, keepMemory, giveMemoryBack};
        const double done = dWorldSetStepMemoryManager(world, &functions);
        player.tell("returns", &done, 1);
        return true;
    }, 1);
}

// --- handlers -----------------------------------------------------------------------------------------------

void addHandlers(std::vector<Function> &all) {
    byHand(all, "dSetMessageHandler", {number(Meaning::flag)}, [](Player &player, const Arguments &arguments, Reference &) {
        player.setMessages(whole(arguments[0]) != 0);
        return true;
    }, 1);
    byHand(all, "dMessage", {number(Meaning::count)}, [](Player &, const Arguments &arguments, Reference &) {
        dMessage(whole(arguments[0]), "message of the program's");
        return true;
    }, 1);
}

// --- colliders ------------------------------------------------------------------------------------------------

// One contact, half way between the two.
int meetHalfWay(dGeomID o1, dGeomID o2, int, dContactGeom *contact, int) {
    if (shapeCallback) shapeCallback(ShapeCallback::collider);
    const dVector3 up = {0, 0, 1};
    return contactHalfWay(o1, o2, up, dReal(0.0625), *contact);
}

// It cannot be undone: ODE does not report which collider it replaces.
void addColliders(std::vector<Function> &all) {
    byHand(all, "dSetColliderOverride", {number(Meaning::choice), number(Meaning::choice)},
           [](Player &, const Arguments &arguments, Reference &) {
               constexpr int classes[] = {dSphereClass, dBoxClass, dCapsuleClass, dCylinderClass};
               dSetColliderOverride(classes[whole(arguments[0]) & 3], classes[whole(arguments[1]) & 3], meetHalfWay);
               return true;
           }, 1);
}

// --- threads --------------------------------------------------------------------------------------------------

// A pool of ODE's as the program's threads. They live as long as the process.
dThreadingImplementationID pool() {
    constexpr unsigned kThreads = 3;
    static const dThreadingImplementationID made = [] {
        const dThreadingImplementationID threading = dThreadingAllocateMultiThreadedImplementation();
        dThreadingThreadPoolServeMultiThreadedImplementation(
            dThreadingAllocateThreadPool(kThreads, 0, dAllocateFlagBasicData, nullptr), threading);
        return threading;
    }();
    return made;
}

// The world's own threads: none, the calling one, or a pool. With a pool upstream's results are others on every run: there the
// world stays without. A jump out of a step would leave the pool's mutex locked.
void addThreads(std::vector<Function> &all) {
    byHand(all, "dWorldSetStepThreadingImplementation", {object(ObjectKind::world), number(Meaning::choice)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]);
               if (world == nullptr) return false;
               static const dThreadingImplementationID self = dThreadingAllocateSelfThreadedImplementation();
               const int which = whole(arguments[1]) % 3;
               const dThreadingImplementationID threading = which == 1 ? self : which == 2 && isOurs() && !player.jumps() ? pool() : nullptr;
               dWorldSetStepThreadingImplementation(world, threading != nullptr ? dThreadingImplementationGetFunctions(threading) : nullptr,
                                                    threading);
               return true;
           }, 1);
}

// --- random numbers -------------------------------------------------------------------------------------------

void addRandomMatrices(std::vector<Function> &all) {
    const auto addMaker = [&](const char *name, auto make) {
        byHand(all, name, {number(Meaning::choice), number(Meaning::size)}, [make](Player &player, const Arguments &arguments, Reference &) {
            const int size = 1 + (whole(arguments[0]) & 7);
            std::vector<dReal> numbers(static_cast<std::size_t>(dPAD(size) * size));
            make(numbers.data(), size, real(arguments[1]));
            player.tell("gives", numbers.data(), static_cast<int>(numbers.size()));
            return true;
        }, 1);
    };
    addMaker("dMakeRandomVector", [](dReal *numbers, int size, dReal range) { dMakeRandomVector(numbers, size, range); });
    addMaker("dMakeRandomMatrix", [](dReal *numbers, int size, dReal range) { dMakeRandomMatrix(numbers, size, size, range); });
}

}  // namespace

void addProgramFunctions(std::vector<Function> &all) {
    addMemory(all);
    addHandlers(all);
    addColliders(all);
    addThreads(all);
    addRandomMatrices(all);
}

}  // namespace fuzz
