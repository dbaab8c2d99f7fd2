/* Control over workers, for docs/threads.md: the same bits whoever works. */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

/* [buffers] */
typedef struct Buffer {
    _Alignas(64) long hits; /* on a cache line of its own */
} Buffer;

static Buffer buffers[dODE_MT_MAX_THREADS];

static void nearWithBuffers(void *data, dGeomID a, dGeomID b) {
    Buffer *own = &buffers[dODE_MT_GetWorkerIndex()]; /* no other callback writes to it meanwhile */
    dContact contact[8];
    (void)data;
    int count = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
    own->hits += count;
    for (int i = 0; i < count; ++i) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = 0.8;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
}

static long allHits(void) {
    long sum = 0;
    for (int i = 0; i < dODE_MT_GetWorkerCount(space); ++i) sum += buffers[i].hits;
    return sum;
}
/* [buffers] */

/* [executor] */
/* Whatever the program has: a pool, a task system. Here each piece of work gets a thread of its own. */
typedef struct Piece {
    dODE_MT_Work *work;
    void *data;
} Piece;

static void *runPiece(void *of) {
    Piece piece = *(Piece *)of;
    free(of);
    piece.work(piece.data);
    return NULL;
}

static void post(void *context, dODE_MT_Work *work, void *data) {
    Piece *piece = malloc(sizeof *piece);
    pthread_t thread;
    *piece = (Piece){work, data};
    atomic_fetch_add((atomic_int *)context, 1);
    pthread_create(&thread, NULL, runPiece, piece);
    pthread_detach(thread);
}
/* [executor] */

/* [hooks] */
static atomic_int running;

static void started(void *data, int worker) {
    (void)data, (void)worker;
    dAllocateODEDataForThread(dAllocateMaskAll); /* or: bind the thread, name it to a profiler */
    atomic_fetch_add(&running, 1);
}

static void ended(void *data, int worker) {
    (void)data, (void)worker;
    dCleanupODEAllDataForThread();
    atomic_fetch_sub(&running, 1);
}
/* [hooks] */

static unsigned long long run(void) {
    for (int i = 0; i < dODE_MT_MAX_THREADS; ++i) buffers[i].hits = 0;
    for (int frame = 0; frame < 30; ++frame) {
        dSpaceCollide(space, 0, nearWithBuffers);
        dWorldQuickStep(world, 0.01);
        dJointGroupEmpty(contacts);
    }
    return stateOfTowers();
}

int main(void) {
    dInitODE2(0);
    dODE_MT_SetAlgorithm("lcp"); /* in parallel whatever it costs: this is a sample, not a measurement */
    setUpTowers();
    const unsigned long long serial = run();
    const long hits = allHits();
    destroyTowers();

    setUpTowers();
    /* [own] */
    dODE_MT_SetWorldThreads(world, 3); /* whatever the process has; 1: the calling thread alone */
    dODE_MT_SetSpaceThreads(space, 2);
    /* [own] */
    dODE_MT_SetCallbackPolicy("independent");
    unsigned long long parallel = run();
    if (parallel != serial || allHits() != hits) return EXIT_FAILURE;
    destroyTowers();

    dToggleODE_MT(4);
    setUpTowers();
    atomic_int posted = 0;
    /* [lend] */
    dODE_MT_SetExecutor(post, &posted);
    parallel = run();                /* up to 4 threads: this one, and 3 that the executor brings */
    dODE_MT_SetExecutor(NULL, NULL); /* the library's own from now on; the program's have left it */
    /* [lend] */
    if (parallel != serial || allHits() != hits) return EXIT_FAILURE;
    destroyTowers();

    setUpTowers();
    /* [options] */
    const int processors[] = {0};
    if (!dODE_MT_SetWorkerName("physics") ||             /* physics-1, physics-2, ... */
        !dODE_MT_SetWorkerAffinity(processors, 1) ||     /* on the first processor alone */
        !dODE_MT_SetWorkerPriority("batch", 5) ||        /* less urgent than the program's other threads */
        !dODE_MT_SetWorkerStackSize(1 << 20) ||          /* 1 MiB is enough for callbacks that take little */
        !dODE_MT_SetWorkerHooks(started, ended, NULL)) { /* each refusal is reported with its reason */
        return EXIT_FAILURE;
    }
    /* [options] */
    parallel = run();
    destroyTowers();
    printf("%d pieces of work were posted, %d workers run\n", posted, running);
    dCloseODE();
    return parallel == serial && running == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
