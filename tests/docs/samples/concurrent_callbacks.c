/* A near-callback made fit for several threads, for docs/callbacks.md: the same bits before and after. */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

/* [before] */
static dContact shared[8]; /* one buffer for all callbacks: two threads would write to it */
static int hits;           /* a plain counter: two threads would lose counts */

static void nearSerial(void *data, dGeomID a, dGeomID b) {
    (void)data;
    int count = dCollide(a, b, 8, &shared[0].geom, sizeof(dContact));
    hits += count;
    for (int i = 0; i < count; ++i) {
        shared[i].surface.mode = dContactApprox1;
        shared[i].surface.mu = 0.8;
        dJointAttach(dJointCreateContact(world, contacts, &shared[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
}
/* [before] */

/* [independent] */
static atomic_int concurrentHits;

static void nearIndependent(void *data, dGeomID a, dGeomID b) {
    dContact contact[8]; /* on the stack: each thread has its own */
    (void)data;
    int count = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
    atomic_fetch_add(&concurrentHits, count);
    for (int i = 0; i < count; ++i) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = 0.8;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
}
/* [independent] */

/* [concurrent] */
/* Counts the contacts of each body in the body itself, and wakes it: no other callback of its bodies runs meanwhile. */
static void nearOfBodies(void *data, dGeomID a, dGeomID b) {
    const dBodyID pair[2] = {dGeomGetBody(a), dGeomGetBody(b)};
    nearIndependent(data, a, b);
    for (int i = 0; i < 2; ++i) {
        if (pair[i] == 0) continue; /* the floor */
        int *touched = dBodyGetData(pair[i]);
        ++*touched;
        dBodyEnable(pair[i]);
    }
}
/* [concurrent] */

static unsigned long long run(const char *policy, dNearCallback *near, int *touched) {
    setUpTowers();
    for (int i = 0; i < kBoxes; ++i) dBodySetData(boxes[i], &touched[i]);
    /* [policy] */
    if (!dODE_MT_SetCallbackPolicy(policy)) return 0; /* "serial", "concurrent" or "independent"; else a dMessage */
    /* [policy] */
    for (int frame = 0; frame < 30; ++frame) {
        dSpaceCollide(space, 0, near);
        dWorldQuickStep(world, 0.01);
        dJointGroupEmpty(contacts);
    }
    unsigned long long state = stateOfTowers();
    destroyTowers();
    return state;
}

int main(void) {
    static int first[kBoxes], second[kBoxes], third[kBoxes];
    dInitODE2(0);
    dToggleODE_MT(4);
    dODE_MT_SetAlgorithm("lcp"); /* in parallel whatever it costs: this is a sample, not a measurement */
    const unsigned long long serial = run("serial", nearSerial, first);
    const unsigned long long independent = run("independent", nearIndependent, second);
    /* [check] */
    const unsigned calls = dODE_MT_GetParallelCollisions();
    const unsigned long long concurrent = run("concurrent", nearOfBodies, third);
    printf("%u collisions had callbacks on several threads\n", dODE_MT_GetParallelCollisions() - calls);
    /* [check] */
    printf("serial %016llx, independent %016llx, concurrent %016llx\n", serial, independent, concurrent);
    int all = 0;
    for (int i = 0; i < kBoxes; ++i) all += third[i];
    const int isSame = serial != 0 && serial == independent && serial == concurrent && concurrentHits == 2 * hits && all > 0;
    dCloseODE();
    return isSame ? EXIT_SUCCESS : EXIT_FAILURE;
}
