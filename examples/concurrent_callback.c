/* A near-callback that several threads may call at the same time: it writes to nothing but its own variables. Prints the height of a
 * heap of spheres, which does not depend on the number of threads. */
#include <ode/ode.h>
#include <stdio.h>

enum { SPHERES = 600, PER_ROW = 10, STEPS = 100 };

typedef struct Scene {
    dWorldID world;
    dJointGroupID contacts;
} Scene;

/* What is shared is only read (docs/callbacks.md). The array is on the stack of each call: one `static` array, as in many
 * programs, would be written by all threads. */
static void collide(void *data, dGeomID geom1, dGeomID geom2) {
    const Scene *scene = data;
    dContact contacts[4];
    const int count = dCollide(geom1, geom2, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; i++) {
        contacts[i].surface.mode = dContactApprox1;
        contacts[i].surface.mu = 0.3;
        const dJointID joint = dJointCreateContact(scene->world, scene->contacts, &contacts[i]);
        dJointAttach(joint, dGeomGetBody(geom1), dGeomGetBody(geom2));
    }
}

int main(void) {
    dInitODE2(0);
    dToggleODE_MT(dODE_MT_AUTO);
    dODE_MT_SetCallbackPolicy("independent"); /* the program's word that any of its callbacks may run at the same time */

    Scene scene = {dWorldCreate(), dJointGroupCreate(0)};
    const dSpaceID space = dHashSpaceCreate(NULL);
    dWorldSetGravity(scene.world, 0, 0, -9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    dBodyID bodies[SPHERES];
    dMass mass;
    dMassSetSphereTotal(&mass, 1, 0.2);
    for (int i = 0; i < SPHERES; i++) {
        const int layer = i / (PER_ROW * PER_ROW), place = i % (PER_ROW * PER_ROW);
        bodies[i] = dBodyCreate(scene.world);
        dBodySetMass(bodies[i], &mass);
        dBodySetPosition(bodies[i], 0.41 * (place % PER_ROW) + 0.05 * layer, 0.41 * (place / PER_ROW), 0.2 + 0.45 * layer);
        dGeomSetBody(dCreateSphere(space, 0.2), bodies[i]);
    }

    for (int step = 0; step < STEPS; step++) {
        dSpaceCollide(space, &scene, collide);
        dWorldQuickStep(scene.world, 0.01);
        dJointGroupEmpty(scene.contacts);
    }
    double top = 0;
    for (int i = 0; i < SPHERES; i++)
        if (dBodyGetPosition(bodies[i])[2] > top) top = dBodyGetPosition(bodies[i])[2];
    printf("top of the heap: %.4f m\n", top);
    fprintf(stderr, "%u of %d calls of dSpaceCollide had callbacks on several threads\n", dODE_MT_GetParallelCollisions(), (int)STEPS);

    dJointGroupDestroy(scene.contacts);
    dSpaceDestroy(space);
    dWorldDestroy(scene.world);
    dCloseODE();
    return 0;
}
