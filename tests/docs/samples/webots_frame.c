/* Calls that programs make of the multithreaded ODE of Webots, for docs/start.md. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

static int updates;

/* [update] */
static void update(int thread) {
    for (int i = 0; i < dThreadGetSpacesCount(thread); ++i) {
        dSpaceID handled = dThreadGetSpaceID(thread, i); /* here: the space of the frame itself */
        if (handled == space) ++updates;
    }
    dJointGroupEmpty(contacts);
}
/* [update] */

int main(void) {
    dInitODE2(0);
    setUpTowers();
    for (int i = 0; i < 20; ++i) {
        dWorldQuickStep(world, 0.01);
        dJointGroupEmpty(contacts);
        dSpaceCollide(space, 0, nearCallback);
    }
    const unsigned long long plain = stateOfTowers();
    destroyTowers();

    setUpTowers();
    /* [frame] */
    dToggleODE_MT(2);
    for (int i = 0; i < 20; ++i) dWorldStepAndSpaceCollide(space, 0, nearCallback, world, 0.01, dWorldQuickStep, update);
    /* [frame] */
    const unsigned long long webots = stateOfTowers();
    const int areSame = dAreGeomsSame(dBodyGetFirstGeom(boxes[0]), dBodyGetFirstGeom(boxes[0]));
    destroyTowers();
    dCloseODE();
    printf("plain %016llx, by the calls of Webots %016llx, %d updates\n", plain, webots, updates);
    return plain == webots && updates == 20 && areSame ? EXIT_SUCCESS : EXIT_FAILURE;
}
