/* Stacks of boxes and of cylinders fall on the ground; written in C. Prints the hash of the final state. */
#define _GNU_SOURCE
#include "stacks.h"

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static dBodyID bodies[BODIES];

static void addBody(int stack, int level) {
    dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBox(&mass, DENSITY, EDGE, EDGE, EDGE);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, startX(stack), startY(level), startZ(level));
    dGeomID geom =
        hasCylinders(stack) ? dCreateCylinder(space, EDGE / 2, EDGE) : dCreateBox(space, EDGE, EDGE, EDGE);
    dGeomSetBody(geom, body);
    bodies[stack * LEVELS + level] = body;
}

static void collide(void *data, dGeomID g1, dGeomID g2) {
    (void)data;
    dContact contact[MAX_CONTACTS];
    int count = dCollide(g1, g2, MAX_CONTACTS, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; i++) {
        setSurface(&contact[i].surface);
        dJointID joint = dJointCreateContact(world, contacts, &contact[i]);
        dJointAttach(joint, dGeomGetBody(g1), dGeomGetBody(g2));
    }
}

int main(void) {
    dInitODE2(0);
    world = dWorldCreate();
    space = dHashSpaceCreate(NULL);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, GRAVITY);
    dCreatePlane(space, 0, 0, 1, 0);
    for (int stack = 0; stack < STACKS; stack++)
        for (int level = 0; level < LEVELS; level++) addBody(stack, level);

    for (int step = 0; step < STEPS; step++) {
        dSpaceCollide(space, NULL, collide);
        if (step % 2)
            dWorldStep(world, STEP_SIZE);
        else
            dWorldQuickStep(world, STEP_SIZE);
        dJointGroupEmpty(contacts);
    }
    printState(bodies);

    dSpaceDestroy(space);
    dJointGroupDestroy(contacts);
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
