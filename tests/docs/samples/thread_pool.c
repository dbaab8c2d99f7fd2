/* Upstream's thread pool, kept and replaced, for docs/start.md: the same bits either way. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

static unsigned long long run(void) {
    runFrames(20);
    return stateOfTowers();
}

int main(void) {
    dInitODE2(0);
    setUpTowers();
    const unsigned long long serial = run();
    destroyTowers();

    setUpTowers();
    /* [pool] */
    dThreadingImplementationID threading = dThreadingAllocateMultiThreadedImplementation();
    dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(2, 0, dAllocateFlagBasicData, NULL);
    dThreadingThreadPoolServeMultiThreadedImplementation(pool, threading);
    dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(threading), threading);
    /* [pool] */
    const unsigned long long pooled = run();
    /* [process] */
    dODE_MT_SetThreadingImplementation(dThreadingImplementationGetFunctions(threading), threading); /* collisions, and steps of all worlds */
    dToggleODE_MT(2);
    /* [process] */
    destroyTowers();
    setUpTowers();
    const unsigned long long shared = run();
    dODE_MT_SetThreadingImplementation(NULL, NULL);
    /* [end] */
    dWorldSetStepThreadingImplementation(world, NULL, NULL);
    dThreadingImplementationShutdownProcessing(threading);
    dThreadingThreadPoolWaitIdleState(pool);
    dThreadingFreeThreadPool(pool);
    dThreadingFreeImplementation(threading);
    /* [end] */
    destroyTowers();

    setUpTowers();
    /* [instead] */
    dToggleODE_MT(2); /* collisions use the threads, too */
    /* [instead] */
    const unsigned long long own = run();
    destroyTowers();
    dCloseODE();
    printf("serial %016llx, pool %016llx, pool of the process %016llx, own threads %016llx\n", serial, pooled, shared, own);
    return serial == pooled && serial == shared && serial == own ? EXIT_SUCCESS : EXIT_FAILURE;
}
