/* A program for odemt_check: a row of boxes that fall on a plane. Its first argument says what it does besides; all but `equal` do
 * that on ODE_MT alone, or are a way of using ODE that has to be observed. The second one, where there is one, is a file whose
 * number of bytes is that of the runs before. */
#include <dlfcn.h>
#include <ode/ode.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { kBoxes = 8, kSteps = 60 };

typedef struct Scene {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    dBodyID boxes[kBoxes];
    dReal stepSize;
    int isExact; /* no step draws random numbers, whose sequence all threads share */
} Scene;

static const char *mode = "equal";

static int is(const char *name) { return strcmp(mode, name) == 0; }
static int isOurs(void) { return dCheckConfiguration("ODE_EXT_mt"); }

static void collide(void *data, dGeomID geom1, dGeomID geom2) {
    Scene *scene = data;
    dContact contacts[4];
    memset(contacts, 0, sizeof contacts);
    const int count = dCollide(geom1, geom2, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mode = dContactApprox1;
        contacts[i].surface.mu = 0.5;
        dJointAttach(dJointCreateContact(scene->world, scene->contacts, &contacts[i]), dGeomGetBody(geom1), dGeomGetBody(geom2));
    }
}

static void addBox(Scene *scene, int i, dReal height) {
    dMass mass;
    dMassSetBoxTotal(&mass, 1 + i, 0.4, 0.3, 0.2);
    scene->boxes[i] = dBodyCreate(scene->world);
    dBodySetMass(scene->boxes[i], &mass);
    dBodySetPosition(scene->boxes[i], 0.3 * i, 0, height);
    dGeomSetBody(dCreateBox(scene->space, 0.4, 0.3, 0.2), scene->boxes[i]);
}

static Scene makeScene(dReal height) {
    Scene scene = {dWorldCreate(), dHashSpaceCreate(NULL), dJointGroupCreate(0), {NULL}, 0.01,
                   is("threads") || is("threads-differ") || is("exchange") || is("pool") || is("pool-differs")};
    dWorldSetGravity(scene.world, 0, 0, -9.81);
    dCreatePlane(scene.space, 0, 0, 1, 0);
    for (int i = 0; i < kBoxes; ++i) addBox(&scene, i, height + 0.1 * i);
    return scene;
}

static void replaceBox(Scene *scene, int i) {
    dGeomDestroy(dBodyGetFirstGeom(scene->boxes[i]));
    dBodyDestroy(scene->boxes[i]);
    addBox(scene, i, 1);
}

static void step(Scene *scene, int number) {
    if (number % 2 == 0) replaceBox(scene, number == 54 ? 4 : 2); /* bodies come and go */
    dSpaceCollide(scene->space, scene, collide);
    if (number % 2 == 0 || scene->isExact)
        dWorldStep(scene->world, scene->stepSize);
    else
        dWorldQuickStep(scene->world, scene->stepSize);
    dJointGroupEmpty(scene->contacts);
}

static void steps(Scene *scene, int first, int last) {
    for (int number = first; number <= last; ++number) step(scene, number);
}

static void end(Scene *scene) {
    dJointGroupDestroy(scene->contacts);
    dSpaceDestroy(scene->space);
    dWorldDestroy(scene->world);
}

/* Number of the runs before this one. */
static int countRun(const char *file) {
    FILE *const stream = fopen(file, "a");
    fseek(stream, 0, SEEK_END);
    const int runs = (int)ftell(stream);
    fputc('.', stream);
    fclose(stream);
    return runs;
}

static unsigned nanoseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (unsigned)now.tv_nsec;
}

/* libode8 steps worlds of several threads only one at a time. */
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

static void *stepOnThread(void *data) {
    Scene *const scene = data;
    for (int number = 1; number <= kSteps; ++number) {
        pthread_mutex_lock(&mutex);
        if (is("threads-differ") && isOurs() && number == 30 && dBodyGetPosition(scene->boxes[0])[2] > 1)
            dBodyAddTorque(scene->boxes[1], 0, 0.001, 0);
        step(scene, number);
        pthread_mutex_unlock(&mutex);
    }
    return NULL;
}

static void *makeOnThread(void *scene) {
    *(Scene *)scene = makeScene(3);
    return NULL;
}

/* Threads make a world each, in an order that changes from run to run. */
static void makeTwoWorlds(Scene scenes[2], int runs) {
    pthread_t thread;
    if (runs % 2 == 0) scenes[0] = makeScene(0.5);
    pthread_create(&thread, NULL, makeOnThread, &scenes[1]);
    pthread_join(thread, NULL);
    if (runs % 2 != 0) scenes[0] = makeScene(0.5);
}

static void stepTwoWorlds(int runs) {
    Scene scenes[2];
    if (is("exchange")) { /* all on this thread */
        for (int i = 0; i < 2; ++i) scenes[i] = makeScene(i == isOurs() ? 0.5 : 3);
    } else {
        makeTwoWorlds(scenes, runs);
    }
    pthread_t threads[2];
    for (int i = 0; i < 2; ++i) pthread_create(&threads[i], NULL, stepOnThread, &scenes[i]);
    for (int i = 0; i < 2; ++i) pthread_join(threads[i], NULL);
    for (int i = 0; i < 2; ++i) end(&scenes[i]);
}

/* The child goes on with the world that it has of its parent, and makes one of its own. */
static int stepInTwoProcesses(Scene *scene) {
    steps(scene, 1, 10);
    const pid_t child = fork();
    if (child == 0) {
        if (is("fork-differs") && isOurs()) dBodyAddForce(scene->boxes[3], 0, 0, 1);
        steps(scene, 11, 30);
        Scene own = makeScene(2);
        steps(&own, 1, 15);
        _exit(0);
    }
    steps(scene, 11, kSteps);
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

/* A task of a pool: a world of its own. */
static void doTask(int task) {
    Scene scene = makeScene(0.5 + task);
    steps(&scene, 1, 10);
    if (task == 2 && is("pool-differs") && isOurs()) dBodyAddForce(scene.boxes[3], 0, 0, 1);
    steps(&scene, 11, 20);
    end(&scene);
}

/* Two processes share four tasks, each time in one of two ways. In modes "pool-random..." a task draws random numbers, which go on
 * from those of the process's task before. */
static int stepInPool(int isOtherWay) {
    int result = 0;
    for (int process = 0; process < 2; ++process)
        if (fork() == 0) {
            for (int task = 0; task < 4; ++task)
                if (process == (isOtherWay ? task == 1 : task >= 2)) doTask(task);
            if (is("pool") && process != isOtherWay) usleep(100000);
            dMessage(7, "of process %d", process);
            _exit(0);
        }
    for (int process = 0, status = -1; process < 2; ++process) wait(&status), result |= status;
    return result;
}

/* Pushed a little, before this step. */
static void stepWithPush(Scene *scene, int at) {
    steps(scene, 1, at - 1);
    if (isOurs()) dBodyAddForce(scene->boxes[5], 0.001, 0, 0);
    steps(scene, at, kSteps);
}

static void setField(dBodyID body, char field) {
    const dQuaternion quaternion = {0, 1, 0, 0};
    if (field == 'p') dBodySetPosition(body, 101, 0, 0);
    if (field == 'q') dBodySetQuaternion(body, quaternion);
    if (field == 'l') dBodySetLinearVel(body, 0, 1, 0);
    if (field == 'a') dBodySetAngularVel(body, 0, 0, 1);
    if (field == 'f') dBodySetForce(body, 1, 0, 0);
    if (field == 't') dBodySetTorque(body, 0, 1, 0);
    if (field == 'e') dBodyEnable(body);
}

/* A body that the steps leave alone, as it is disabled and far away. */
static void stepWithField(Scene *scene, char field) {
    const dBodyID body = dBodyCreate(scene->world);
    dBodyDisable(body);
    dBodySetPosition(body, 100, 0, 0);
    steps(scene, 1, 5);
    if (isOurs()) setField(body, field);
    steps(scene, 6, 6);
}

static int play(Scene *scene, int runs) {
    const char *const threads = getenv("ODE_MT_THREADS");
    if (is("push")) return stepWithPush(scene, 37), 0;
    if (is("push-late")) return stepWithPush(scene, 57), 0;
    if (is("push-two-threads"))
        return threads != NULL && strcmp(threads, "2") == 0 ? stepWithPush(scene, 37) : steps(scene, 1, kSteps), 0;
    if (is("push-sometimes")) return stepWithPush(scene, 20 + runs), 0;
    if (is("push-by-chance") && (runs == 1 || runs == 4)) dBodyAddForce(scene->boxes[5], 0.001, 0, 0);
    if (is("push-once")) return runs == 1 ? stepWithPush(scene, 37) : steps(scene, 1, kSteps), 0;
    if (is("fork") || is("fork-differs")) return stepInTwoProcesses(scene);
    if (strncmp(mode, "field-", 6) == 0) return stepWithField(scene, mode[6]), 0;
    if (is("clock")) scene->stepSize = 0.01 + 1e-12 * nanoseconds();
    if (is("crash-everywhere") || (is("crash") && isOurs()) || (is("crash-once") && runs == 0)) {
        steps(scene, 1, 20);
        fprintf(stderr, "last words\n");
        abort();
    }
    if (is("input")) {
        int last = 0;
        if (scanf("%d", &last) != 1) return 3;
        return steps(scene, 1, last), 0;
    }
    if (is("interrupt")) { /* ends Ctrl-C on whoever has started it, in the run on ODE_MT, and goes on until that reaches it */
        steps(scene, 1, 30);
        if (isOurs()) kill(getppid(), SIGINT);
    }
    if (is("endless") || (is("interrupt") && isOurs()))
        for (int number = 31;; ++number) usleep(1000), step(scene, number);
    if (is("slow-on-libode8") && !isOurs()) {
        steps(scene, 1, 30);
        for (;;) pause();
    }
    if (is("more-each-run")) return steps(scene, 1, kSteps + runs), 0;
    steps(scene, 1, is("more-steps") && isOurs() ? kSteps + 5 : kSteps);
    while (is("hang") && isOurs()) pause();
    if (is("message") && isOurs()) dMessage(7, "a message of ODE's");
    if (is("output")) printf("%s\n", isOurs() ? "ODE_MT" : "libode8");
    return is("exit-code") && isOurs() ? 4 : 0;
}

int main(int argc, char **argv) {
    if (argc > 1) mode = argv[1];
    const int runs = argc > 2 ? countRun(argv[2]) : 0;
    dInitODE2(0);
    int result = 0;
    if (is("no-steps")) {
        dWorldDestroy(dWorldCreate());
    } else if (is("threads") || is("threads-differ") || is("exchange")) {
        stepTwoWorlds(runs);
    } else if (strncmp(mode, "pool", 4) == 0) {
        result = stepInPool(runs == 1 || (runs % 2 != 0 && !is("pool-random-once")) || (runs == 4 && is("pool-random")));
    } else {
        Scene scene = makeScene(0.5);
        result = play(&scene, runs);
        end(&scene);
    }
    dCloseODE();
    return result;
}
