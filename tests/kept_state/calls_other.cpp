// Recipes for functions about the process: initialisation, handlers, memory, random numbers, lent threads.
#include "call_recipes.h"

#include <ode/cooperative.h>
#include <ode/export-dif.h>
#include <ode/matrix_coop.h>
#include <ode/threading_impl.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace kept_state {

namespace {

void *allocate(dsizeint size) { return std::malloc(size); }
void *reallocate(void *block, dsizeint, dsizeint size) { return std::realloc(block, size); }
void release(void *block, dsizeint) { std::free(block); }

using Calls = void (*)(CallScene &);

struct Adder {
    CallRecipes &recipes;
    void operator()(const char *name, Calls call) { recipes.push_back({name, call}); }
};

void addProcess(Adder add) {
    add("dInitODE", [](CallScene &) {
        dInitODE();
        dCloseODE();
    });
    add("dInitODE2", [](CallScene &s) { s.tell(dInitODE2(0)); });
    add("dCloseODE", [](CallScene &) {
        dInitODE2(0);
        dCloseODE();
    });
    add("dAllocateODEDataForThread",
        [](CallScene &s) { s.tell(dAllocateODEDataForThread(dAllocateMaskAll)); });
    add("dCleanupODEAllDataForThread", [](CallScene &) {
        dCleanupODEAllDataForThread();
        dAllocateODEDataForThread(dAllocateMaskAll);
    });
    add("dGetConfiguration", [](CallScene &s) { s.trace.line(dGetConfiguration()); });
    add("dCheckConfiguration", [](CallScene &s) { s.tell(dCheckConfiguration("ODE_double_precision")); });
    add("dWorldExportDIF", [](CallScene &s) {
        char *text = nullptr;
        std::size_t size = 0;
        std::FILE *const file = open_memstream(&text, &size);
        dWorldExportDIF(s.world, file, "world");
        std::fclose(file);
        s.tell(size > 100);  // names are addresses, and some numbers unset
        std::free(text);
    });
}

void addHandlers(Adder add) {
    add("dSetErrorHandler", [](CallScene &) { dSetErrorHandler(dGetErrorHandler()); });
    add("dSetDebugHandler", [](CallScene &) { dSetDebugHandler(dGetDebugHandler()); });
    add("dSetMessageHandler", [](CallScene &) { dSetMessageHandler(dGetMessageHandler()); });
    add("dGetErrorHandler", [](CallScene &s) { s.tell(dGetErrorHandler() != nullptr); });
    add("dGetDebugHandler", [](CallScene &s) { s.tell(dGetDebugHandler() != nullptr); });
    add("dGetMessageHandler", [](CallScene &s) { s.tell(dGetMessageHandler() != nullptr); });
    add("dError", [](CallScene &) { dError(5, "the user's %d", 7); });
    add("dDebug", [](CallScene &) { dDebug(6, "the user's %d", 8); });
    add("dMessage", [](CallScene &) { dMessage(7, "the user's %d", 9); });
}

void addMemory(Adder add) {
    add("dSetAllocHandler", [](CallScene &) { dSetAllocHandler(allocate); });
    add("dSetReallocHandler", [](CallScene &) { dSetReallocHandler(reallocate); });
    add("dSetFreeHandler", [](CallScene &) { dSetFreeHandler(release); });
    add("dGetAllocHandler", [](CallScene &s) { s.tell(dGetAllocHandler() != nullptr); });
    add("dGetReallocHandler", [](CallScene &s) { s.tell(dGetReallocHandler() != nullptr); });
    add("dGetFreeHandler", [](CallScene &s) { s.tell(dGetFreeHandler() != nullptr); });
    add("dAlloc", [](CallScene &) { dFree(dAlloc(100), 100); });
    add("dRealloc", [](CallScene &) { dFree(dRealloc(dAlloc(100), 100, 200), 200); });
    add("dFree", [](CallScene &) { dFree(dAlloc(1), 1); });
}

void addRandom(Adder add) {
    add("dTestRand", [](CallScene &s) { s.tell(dTestRand()); });
    add("dRand", [](CallScene &s) { s.tell(dRand()); });
    add("dRandGetSeed", [](CallScene &s) { s.tell(dRandGetSeed()); });
    add("dRandSetSeed", [](CallScene &) { dRandSetSeed(99); });
    add("dRandInt", [](CallScene &s) { s.tell(dRandInt(10)); });
    add("dRandReal", [](CallScene &s) { s.tell(dRandReal()); });
}

// Made, used and freed again at once.
void lend(CallScene &s, dThreadingImplementationID implementation) {
    s.tell(dThreadingImplementationGetFunctions(implementation) != nullptr);
    dThreadingImplementationShutdownProcessing(implementation);
    dThreadingImplementationCleanupForRestart(implementation);
    dThreadingFreeImplementation(implementation);
}

void lendSelf(CallScene &s) { lend(s, dThreadingAllocateSelfThreadedImplementation()); }

void lendPool(CallScene &s) {
    const dThreadingImplementationID implementation = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(1, 0, dAllocateMaskAll, nullptr);
    dThreadingThreadPoolServeMultiThreadedImplementation(pool, implementation);
    dThreadingImplementationShutdownProcessing(implementation);
    dThreadingThreadPoolWaitIdleState(pool);
    dThreadingFreeThreadPool(pool);
    dThreadingFreeImplementation(implementation);
    s.tell(1);
}

void serveExternally(CallScene &s) {
    const dThreadingImplementationID implementation = dThreadingAllocateMultiThreadedImplementation();
    dThreadingImplementationShutdownProcessing(implementation);
    dExternalThreadingServeMultiThreadedImplementation(implementation, nullptr, nullptr);
    dThreadingFreeImplementation(implementation);
    s.tell(1);
}

void addThreads(Adder add) {
    add("dThreadingAllocateSelfThreadedImplementation", lendSelf);
    add("dThreadingImplementationGetFunctions", lendSelf);
    add("dThreadingImplementationShutdownProcessing", lendSelf);
    add("dThreadingImplementationCleanupForRestart", lendSelf);
    add("dThreadingFreeImplementation", lendSelf);
    add("dThreadingAllocateMultiThreadedImplementation", lendPool);
    add("dThreadingAllocateThreadPool", lendPool);
    add("dThreadingThreadPoolServeMultiThreadedImplementation", lendPool);
    add("dThreadingThreadPoolWaitIdleState", lendPool);
    add("dThreadingFreeThreadPool", lendPool);
    add("dExternalThreadingServeMultiThreadedImplementation", serveExternally);
}

// A factorisation and a solution of a system of three rows by the cooperative functions.
void cooperate(CallScene &s) {
    const dThreadingImplementationID self = dThreadingAllocateSelfThreadedImplementation();
    const dCooperativeID cooperative = dCooperativeCreate(dThreadingImplementationGetFunctions(self), self);
    const dResourceRequirementsID requirements = dResourceRequirementsCreate(cooperative);
    dEstimateCooperativelyFactorLDLTResourceRequirements(requirements, 1, 3);
    const dResourceRequirementsID more = dResourceRequirementsClone(requirements);
    dEstimateCooperativelySolveLDLTResourceRequirements(more, 1, 3);
    dEstimateCooperativelySolveL1StraightResourceRequirements(more, 1, 3);
    dEstimateCooperativelySolveL1TransposedResourceRequirements(more, 1, 3);
    dEstimateCooperativelyScaleVectorResourceRequirements(more, 1, 3);
    dResourceRequirementsMergeIn(requirements, more);
    const dResourceContainerID resources = dResourceContainerAcquire(requirements);
    alignas(64) dReal a[12]{4, 1, 0.5, 0, 1, 5, 0.2, 0, 0.5, 0.2, 6}, d[4]{}, b[4]{1, 2, 3};
    dCooperativelyFactorLDLT(resources, 1, a, d, 3, 4);
    dCooperativelySolveLDLT(resources, 1, a, d, b, 3, 4);
    dCooperativelySolveL1Straight(resources, 1, a, b, 3, 4);
    dCooperativelySolveL1Transposed(resources, 1, a, b, 3, 4);
    dCooperativelyScaleVector(resources, 1, b, d, 3);
    s.tell(b, 3);
    dResourceContainerDestroy(resources);
    dResourceRequirementsDestroy(more);
    dResourceRequirementsDestroy(requirements);
    dCooperativeDestroy(cooperative);
    dThreadingFreeImplementation(self);
}

void addCooperation(Adder add) {
    for (const char *name :
         {"dCooperativeCreate", "dCooperativeDestroy", "dResourceRequirementsCreate",
          "dResourceRequirementsDestroy", "dResourceRequirementsClone", "dResourceRequirementsMergeIn",
          "dResourceContainerAcquire", "dResourceContainerDestroy",
          "dEstimateCooperativelyFactorLDLTResourceRequirements", "dCooperativelyFactorLDLT",
          "dEstimateCooperativelySolveLDLTResourceRequirements", "dCooperativelySolveLDLT",
          "dEstimateCooperativelySolveL1StraightResourceRequirements", "dCooperativelySolveL1Straight",
          "dEstimateCooperativelySolveL1TransposedResourceRequirements", "dCooperativelySolveL1Transposed",
          "dEstimateCooperativelyScaleVectorResourceRequirements", "dCooperativelyScaleVector"})
        add(name, cooperate);
}

}  // namespace

void addOtherCalls(CallRecipes &recipes) {
    CallRecipes r;
    const Adder add{r};
    addProcess(add);
    addHandlers(add);
    addMemory(add);
    addRandom(add);
    addThreads(add);
    addCooperation(add);
    for (CallRecipe &recipe : r) {
        recipe.anySpace = true;
        recipes.push_back(std::move(recipe));
    }
}

}  // namespace kept_state
