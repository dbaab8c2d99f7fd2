/* Many worlds in one call, for docs/threads.md. Compared with a loop. */
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 200, STEPS = 50 };

static dWorldID makeWorld(int number) {
    dWorldID world = dWorldCreate();
    dBodyID last = NULL;
    dWorldSetGravity(world, 0, 0, -9.81);
    for (int i = 0; i < 4; ++i) {
        dBodyID body = dBodyCreate(world);
        dJointID joint = dJointCreateBall(world, NULL);
        dBodySetPosition(body, 0.5 * i, 0.01 * number, 0);
        dJointAttach(joint, body, last);
        dJointSetBallAnchor(joint, 0.5 * i - 0.25, 0, 0);
        last = body;
    }
    return world;
}

int main(void) {
    dWorldID worlds[COUNT], others[COUNT];
    dInitODE2(0);
    for (int i = 0; i < COUNT; ++i) worlds[i] = makeWorld(i);
    for (int i = 0; i < COUNT; ++i) others[i] = makeWorld(i);

    /* [step] */
    dToggleODE_MT(dODE_MT_AUTO);
    for (int step = 0; step < STEPS; ++step)
        if (!dODE_MT_StepWorlds(worlds, COUNT, "quick", 0.01)) return EXIT_FAILURE; /* or "step" */
    /* [step] */
    const unsigned long seed = dRandGetSeed();

    dRandSetSeed(0);
    for (int step = 0; step < STEPS; ++step)
        for (int i = 0; i < COUNT; ++i) dWorldQuickStep(others[i], 0.01);
    if (dRandGetSeed() != seed) return EXIT_FAILURE;
    for (int i = 0; i < COUNT; ++i) {
        dWorldDestroy(worlds[i]);
        dWorldDestroy(others[i]);
    }
    dCloseODE();
    puts("the same random numbers");
    return EXIT_SUCCESS;
}
