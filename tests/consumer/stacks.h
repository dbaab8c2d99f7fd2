/* The scene of both consumer programs, one written in C, one with odecpp.h: stacks of boxes and of
 * cylinders (which ODE collides with libccd) fall on the ground. Numbers, and the hash of the final state,
 * which must not depend on the language. */
#ifndef STACKS_H
#define STACKS_H

#include <dlfcn.h>
#include <ode/ode.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { STACKS = 8, LEVELS = 6, BODIES = STACKS * LEVELS, STEPS = 150, MAX_CONTACTS = 8 };

static const dReal STEP_SIZE = (dReal)0.01; /* s */
static const dReal GRAVITY = (dReal)-9.81;  /* m/s^2 */
static const dReal EDGE = (dReal)0.5;       /* m; also diameter and length of a cylinder */
static const dReal DENSITY = 1;             /* kg/m^3 */

/* Where the body of a level starts: apart from its neighbours, and shifted, so that stacks topple. */
static inline dReal startX(int stack) { return (dReal)(4 * stack); }
static inline dReal startY(int level) { return (dReal)0.11 * (dReal)level; }
static inline dReal startZ(int level) { return EDGE * (dReal)(1.2 * level + 1); }

static inline int hasCylinders(int stack) { return stack % 2; }

static inline void setSurface(dSurfaceParameters *surface) {
    surface->mode = dContactApprox1;
    surface->mu = (dReal)0.6;
}

/* FNV-1a over the bytes of `count` numbers. */
static inline uint64_t hashNumbers(uint64_t hash, const dReal *numbers, int count) {
    const unsigned char *bytes = (const unsigned char *)numbers;
    for (size_t i = 0; i < (size_t)count * sizeof(dReal); i++)
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    return hash;
}

/* Prints the hash of all poses and velocities and, if the library is a shared ODE_MT, how many steps it
 * that ran in parallel. They are looked up by name, so that the program also links to upstream's library. */
static inline void printState(const dBodyID *bodies) {
    uint64_t hash = UINT64_C(14695981039346656037);
    for (int i = 0; i < BODIES; i++) {
        hash = hashNumbers(hash, dBodyGetPosition(bodies[i]), 3);
        hash = hashNumbers(hash, dBodyGetQuaternion(bodies[i]), 4);
        hash = hashNumbers(hash, dBodyGetLinearVel(bodies[i]), 3);
        hash = hashNumbers(hash, dBodyGetAngularVel(bodies[i]), 3);
    }
    printf("hash %016llx\n", (unsigned long long)hash);
    unsigned (*parallelSteps)(void);
    *(void **)&parallelSteps = dlsym(RTLD_DEFAULT, "dODE_MT_GetParallelSteps");
    if (parallelSteps) printf("parallel steps %u\n", parallelSteps());
}

#endif
