/* Settings by calls, for README.md and docs/settings.md. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

static unsigned long long run(void) {
    runFrames(20);
    unsigned long long state = stateOfTowers();
    destroyTowers();
    return state;
}

int main(void) {
    /* [toggle] */
    dInitODE2(0);
    dToggleODE_MT(dODE_MT_AUTO); /* or a number of threads; 0, the default, is serial */
    /* [toggle] */
    setUpTowers();
    unsigned long long parallel = run();
    dToggleODE_MT(0);
    setUpTowers();
    unsigned long long serial = run();
    if (parallel != serial) return EXIT_FAILURE;

    setUpTowers();
    /* [fast] */
    dODE_MT_SetSolver(world, "fast");        /* this world alone: other bits, less time */
    dODE_MT_SetSolverTolerance(world, 1e-4); /* dWorldQuickStep ends early where forces hardly change */
    /* [fast] */
    printf("exact %016llx, fast %016llx, solver %s\n", serial, run(), "fast");

    /* [quiet] */
    if (dODE_MT_GetThreads() > 1) printf("up to %d threads\n", dODE_MT_GetThreads());
    if (!dODE_MT_SetAlgorithm("auto")) return EXIT_FAILURE; /* 0: there is no such algorithm, and dMessage has named those that are known */
    /* [quiet] */
    /* [policies] */
    dODE_MT_SetCallbackPolicy("independent"); /* or ODE_MT_CALLBACKS=independent: any callbacks at the same time */
    dODE_MT_SetCallbackPolicy("concurrent");  /* or ODE_MT_CALLBACKS=concurrent: those whose pairs share no body */
    /* [policies] */
    dCloseODE();
    return EXIT_SUCCESS;
}
