/* A program for odemt_top: worlds of towers of boxes on a plane.
 *
 *   stepper WORLDS FRAMES [end]
 *
 * Each frame of each world is a collision and a step. Frames 0: until it is ended by a signal. `end` says how it ends: `kept` leaves the
 * worlds alone, `code` exits with 7, `kill` kills itself, `reader` reads standard input and prints how long it was. */
#include <ode/ode.h>

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { kTowers = 10, kFloors = 8, kMaxWorlds = 300 };

typedef struct Scene {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
} Scene;

static void collide(void *data, dGeomID geom1, dGeomID geom2) {
    const Scene *scene = data;
    dContact contacts[4];
    memset(contacts, 0, sizeof contacts);
    const int count = dCollide(geom1, geom2, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mu = 0.5;
        dJointAttach(dJointCreateContact(scene->world, scene->contacts, &contacts[i]), dGeomGetBody(geom1), dGeomGetBody(geom2));
    }
}

static Scene makeScene(int floors) {
    const Scene scene = {dWorldCreate(), dHashSpaceCreate(NULL), dJointGroupCreate(0)};
    dWorldSetGravity(scene.world, 0, 0, -9.81);
    dCreatePlane(scene.space, 0, 0, 1, 0);
    for (int i = 0; i < kTowers * floors; ++i) {
        const dBodyID body = dBodyCreate(scene.world);
        dMass mass;
        dMassSetBox(&mass, 1, 1, 1, 1);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, 3 * (i % kTowers), 0, 0.5 + i / kTowers);
        dGeomSetBody(dCreateBox(scene.space, 1, 1, 1), body);
    }
    return scene;
}

static void frame(Scene *scene) {
    dSpaceCollide(scene->space, scene, collide);
    dWorldQuickStep(scene->world, 0.01);
    dJointGroupEmpty(scene->contacts);
}

static void destroy(Scene *scene) {
    dJointGroupDestroy(scene->contacts);
    dSpaceDestroy(scene->space);
    dWorldDestroy(scene->world);
}

static volatile sig_atomic_t isAsked = 0;
static void onSignal(int number) { isAsked = number; }

int main(int argc, char **argv) {
    const int worlds = argc > 1 ? atoi(argv[1]) : 1;
    const long frames = argc > 2 ? atol(argv[2]) : 100;
    const char *const end = argc > 3 ? argv[3] : "";
    static Scene scenes[kMaxWorlds];
    if (worlds > kMaxWorlds) return EXIT_FAILURE;
    signal(SIGINT, onSignal);
    dInitODE2(0);
    const char *const file = getenv("ODE_MT_STATISTICS");
    printf("begins, file %s\n", file != NULL ? file : "none");
    fflush(stdout);
    for (int i = 0; i < worlds; ++i) scenes[i] = makeScene(i == 0 ? kFloors : 1);
    for (long i = 0; (i < frames || frames == 0) && !isAsked; ++i) {
        for (int k = 0; k < worlds; ++k) frame(&scenes[k]);
        if (frames == 0) nanosleep(&(struct timespec){0, 2000000}, NULL);
    }
    if (strcmp(end, "kill") == 0) raise(SIGKILL);
    long bytes = 0;
    if (strcmp(end, "reader") == 0)
        while (getchar() != EOF) ++bytes;
    fprintf(stderr, "ends with %ld bytes read\n", bytes);
    if (strcmp(end, "kept") == 0) return EXIT_SUCCESS;
    for (int i = 0; i < worlds; ++i) destroy(&scenes[i]);
    dCloseODE();
    return strcmp(end, "code") == 0 ? 7 : EXIT_SUCCESS;
}
