/* Reads off the counters why a world is not faster, for docs/threads.md. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

/* [diagnosis] */
/* Runs frames and prints of how many of them steps and collisions were shared by threads. */
static void diagnose(int frames) {
    dODE_MT_Statistics before, after;
    dODE_MT_GetStatistics(&before);
    runFrames(frames);
    dODE_MT_GetStatistics(&after);
    printf("threads allowed     %d\n", dODE_MT_GetThreads());
    printf("steps by islands    %llu of %d\n", after.parallelSteps - before.parallelSteps, frames);
    printf("steps of one island %llu of %d\n", after.teamSteps - before.teamSteps, frames);
    printf("collisions          %llu of %d\n", after.sharedCollisions - before.sharedCollisions, frames);
    printf("their callbacks     %llu of %d\n", after.parallelCollisions - before.parallelCollisions, frames);
    printf("contacts prefetched %llu, not used %llu\n", after.contactsAhead - before.contactsAhead,
           after.contactsAheadUnused - before.contactsAheadUnused);
}
/* [diagnosis] */

int main(void) {
    dInitODE2(0);
    dToggleODE_MT(2);
    setUpTowers();
    runFrames(20);
    diagnose(20);
    dODE_MT_Statistics all;
    dToggleODE_MT(0);
    dODE_MT_GetStatistics(&all);
    const unsigned long long steps = all.parallelSteps + all.teamSteps;
    diagnose(20); /* one thread: nothing is shared */
    dODE_MT_GetStatistics(&all);
    destroyTowers();
    dCloseODE();
    return all.parallelSteps + all.teamSteps == steps ? EXIT_SUCCESS : EXIT_FAILURE;
}
