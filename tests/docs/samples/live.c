/* Asks for the last frame of a world, for docs/tools.md, and for what workers have done, for docs/remote.md. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

/* [live] */
/* Prints how the last frame of the world went, and returns whether there was one. */
static int tellOfFrame(void) {
    dODE_MT_WorldStatistics last;
    last.size = sizeof last;
    if (!dODE_MT_GetWorldStatistics(world, &last)) return 0; /* frames are recorded from the first call on */
    printf("collision %.3f ms, step %.3f ms, %u islands, %llu rows\n", 1e3 * last.collisionTime, 1e3 * last.stepTime, last.islands, last.rows);
    printf("the step: %s\n", dODE_MT_GetReasonText(last.stepReason));
    return 1;
}
/* [live] */

/* [remote] */
/* Prints what workers in other processes have done for all worlds. */
static void tellOfWorkers(void) {
    dODE_MT_RemoteStatistics remote;
    remote.size = sizeof remote;
    dODE_MT_GetRemoteStatistics(&remote);
    printf("%u workers, %u lost: %llu islands solved of %llu sent, %llu late\n", remote.workers, remote.workersLost, remote.islandsSolved,
           remote.islandsSent, remote.islandsLate);
}
/* [remote] */

int main(void) {
    dInitODE2(0);
    setUpTowers();
    const int isEarly = tellOfFrame();
    runFrames(3);
    const int isTold = tellOfFrame();
    tellOfWorkers();
    destroyTowers();
    dCloseODE();
    return !isEarly && isTold ? EXIT_SUCCESS : EXIT_FAILURE;
}
