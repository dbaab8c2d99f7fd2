/* A program that uses MPI itself, with workers of ODE_MT's besides:
 *
 *   ODE_MT_WORKERS=mpi:1 ODE_MT_ALGORITHM=lcp own_mpi close|leave|finalise
 *
 * dCloseODE comes before MPI_Finalize, never, or after it. Prints where its chains hang after their steps, half of which come after the end of MPI
 * in the last case; "the end" is the last line. */
#include <mpi.h>
#include <ode/ode.h>

#include <stdio.h>
#include <string.h>

enum { kChains = 8, kLinks = 20, kSteps = 20 };

static dBodyID s_links[kChains][kLinks];

static dWorldID makeChains(void) {
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    for (int c = 0; c < kChains; ++c) {
        for (int k = 0; k < kLinks; ++k) {
            dMass mass;
            dMassSetBox(&mass, 1000, 0.2, 0.1, 0.1);
            s_links[c][k] = dBodyCreate(world);
            dBodySetMass(s_links[c][k], &mass);
            dBodySetPosition(s_links[c][k], 0.2 * k, c, 0);
            const dJointID joint = dJointCreateHinge(world, 0);
            dJointAttach(joint, s_links[c][k], k > 0 ? s_links[c][k - 1] : 0);
            dJointSetHingeAnchor(joint, 0.2 * k - 0.1, c, 0);
            dJointSetHingeAxis(joint, 0, 1, 0);
        }
    }
    return world;
}

static void step(dWorldID world, int steps) {
    for (int i = 0; i < steps; ++i) dWorldStep(world, 0.005);
}

int main(int argc, char **argv) {
    int level = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_MULTIPLE, &level);
    if (argc != 2 || level != MPI_THREAD_MULTIPLE) return 2;
    dInitODE2(0);
    const dWorldID world = makeChains();
    step(world, kSteps / 2);
    if (strcmp(argv[1], "finalise") == 0) MPI_Finalize();
    step(world, kSteps / 2);
    for (int c = 0; c < kChains; ++c) {
        const dReal *const p = dBodyGetPosition(s_links[c][kLinks - 1]);
        printf("%.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    if (strcmp(argv[1], "leave") != 0) dCloseODE();
    if (strcmp(argv[1], "finalise") != 0) MPI_Finalize();
    printf("the end\n");
    return 0;
}
