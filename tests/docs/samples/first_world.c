/* A box that falls on a plane, for docs/start.md. The output is the same with libode8 and with ODE_MT, bit by bit. */
/* [world] */
#include <ode/ode.h>
#include <stdio.h>

static dWorldID world;
static dJointGroupID contacts;

static void near(void *data, dGeomID a, dGeomID b) {
    dContact contact[8];
    (void)data;
    for (int i = 0; i < 8; ++i) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = 0.8;
    }
    int count = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i)
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
}

int main(void) {
    dInitODE2(0);
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    contacts = dJointGroupCreate(0);
    dSpaceID space = dHashSpaceCreate(0);
    dCreatePlane(space, 0, 0, 1, 0);

    dBodyID body = dBodyCreate(world);
    dGeomID box = dCreateBox(space, 0.5, 0.5, 0.5);
    dGeomSetBody(box, body);
    dBodySetPosition(body, 0, 0, 2);
    for (int frame = 0; frame < 200; ++frame) {
        dSpaceCollide(space, 0, near);
        dWorldStep(world, 0.01);
        dJointGroupEmpty(contacts);
    }
    printf("height %a m\n", dBodyGetPosition(body)[2]);

    dWorldDestroy(world);
    dSpaceDestroy(space);
    dJointGroupDestroy(contacts);
    dCloseODE();
    return 0;
}
/* [world] */
