/* A box falls on the ground: the least that a program needs. Prints its height, in metres, ten times a second. */
#include <ode/ode.h>
#include <stdio.h>

typedef struct Scene {
    dWorldID world;
    dJointGroupID contacts;
} Scene;

/* Called for each two geoms whose boxes overlap. */
static void collide(void *data, dGeomID geom1, dGeomID geom2) {
    const Scene *scene = data;
    dContact contacts[4];
    const int count = dCollide(geom1, geom2, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; i++) {
        contacts[i].surface.mode = dContactBounce | dContactApprox1;
        contacts[i].surface.mu = 0.5;
        contacts[i].surface.bounce = 0.3;
        contacts[i].surface.bounce_vel = 0.1;
        const dJointID joint = dJointCreateContact(scene->world, scene->contacts, &contacts[i]);
        dJointAttach(joint, dGeomGetBody(geom1), dGeomGetBody(geom2));
    }
}

int main(void) {
    dInitODE2(0);
    printf("ODE %s, ODE_MT %s\n", dODE_VERSION, dODE_MT_GetVersion());
    dToggleODE_MT(dODE_MT_AUTO); /* an upper bound: one box is stepped by this thread alone */

    Scene scene = {dWorldCreate(), dJointGroupCreate(0)};
    const dSpaceID space = dHashSpaceCreate(NULL);
    dWorldSetGravity(scene.world, 0, 0, -9.81);
    dCreatePlane(space, 0, 0, 1, 0);

    const dBodyID box = dBodyCreate(scene.world);
    dMass mass;
    dMassSetBoxTotal(&mass, 2, 0.4, 0.3, 0.2);
    dBodySetMass(box, &mass);
    dBodySetPosition(box, 0, 0, 1);
    dGeomSetBody(dCreateBox(space, 0.4, 0.3, 0.2), box);

    for (int step = 0; step <= 100; step++) {
        if (step % 10 == 0) printf("%.1f s  %.3f m\n", step * 0.01, (double)dBodyGetPosition(box)[2]);
        dSpaceCollide(space, &scene, collide);
        dWorldStep(scene.world, 0.01);
        dJointGroupEmpty(scene.contacts);
    }

    dJointGroupDestroy(scene.contacts);
    dSpaceDestroy(space);
    dWorldDestroy(scene.world);
    dCloseODE();
    return 0;
}
