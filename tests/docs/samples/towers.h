/* Towers of boxes for the samples: `setUpTowers` makes them anew, `stateOfTowers` mixes the bits of all positions. */
#ifndef ODE_MT_SAMPLES_TOWERS_H
#define ODE_MT_SAMPLES_TOWERS_H

#include <ode/ode.h>
#include <string.h>

enum { kTowers = 16, kBoxes = 20 * kTowers };

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static dBodyID boxes[kBoxes];

static inline void setUpTowers(void) {
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    space = dHashSpaceCreate(0);
    contacts = dJointGroupCreate(0);
    dRandSetSeed(0); /* dWorldQuickStep draws random numbers */
    dCreatePlane(space, 0, 0, 1, 0);
    for (int i = 0; i < kBoxes; ++i) {
        dMass mass;
        dMassSetBox(&mass, 1000, 0.2, 0.2, 0.2);
        boxes[i] = dBodyCreate(world);
        dBodySetMass(boxes[i], &mass);
        dBodySetPosition(boxes[i], 2.0 * (i % 4) + 0.002 * (i % 7), 2.0 * (i / 4 % 4), 0.1 + 0.2 * (i / kTowers));
        dGeomSetBody(dCreateBox(space, 0.2, 0.2, 0.2), boxes[i]);
    }
}

static inline unsigned long long stateOfTowers(void) {
    unsigned long long state = 0;
    for (int i = 0; i < kBoxes; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            dReal number = dBodyGetPosition(boxes[i])[axis];
            unsigned long long bits = 0;
            memcpy(&bits, &number, sizeof number);
            state = (state ^ bits) * 1099511628211ULL;
        }
    return state;
}

static inline void destroyTowers(void) {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

/* A near-callback as most programs have it. */
static inline void nearCallback(void *data, dGeomID a, dGeomID b) {
    dContact contact[4];
    (void)data;
    memset(contact, 0, sizeof contact);
    int count = dCollide(a, b, 4, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contact[i].surface.mu = 0.8;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
}

static inline void runFrames(int frames) {
    for (int frame = 0; frame < frames; ++frame) {
        dSpaceCollide(space, 0, nearCallback);
        dWorldQuickStep(world, 0.01);
        dJointGroupEmpty(contacts);
    }
}

#endif
