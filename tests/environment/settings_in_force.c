/* Prints the settings that the library took from the environment, after a step that two threads share; what it reports of
 * variables goes to standard error. The first word says whether the system runs it with rights that its caller does not have. */
#include <ode/ode.h>

#include <stdio.h>
#include <sys/auxv.h>

int main(void) {
    dInitODE2(0);
    printf("secure %lu threads %d algorithm %s callbacks %s heuristics %s cells %d manager %s\n", getauxval(AT_SECURE),
           dODE_MT_GetThreads(), dODE_MT_GetAlgorithm(), dODE_MT_GetCallbackPolicy(), dODE_MT_GetHeuristics(),
           dODE_MT_GetGridCells(), dODE_MT_GetThreadManager());
    /* Whoever disturbs workers and lends them is asked for when there are some. */
    dToggleODE_MT(2);
    dODE_MT_SetAlgorithm("lcp");
    dWorldID world = dWorldCreate();
    dBodyCreate(world);
    dBodyCreate(world);
    dWorldStep(world, 0.01);
    dWorldDestroy(world);
    printf("manager %s at the end\n", dODE_MT_GetThreadManager());
    dCloseODE();
    return 0;
}
