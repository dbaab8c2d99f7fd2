/* A program that finds ODE's functions by their names: loads_ode LIBRARY. A difference is made where ODE_MT's own functions are. */
#include <dlfcn.h>
#include <stddef.h>

int main(int argc, char **argv) {
    void *const ode = argc > 1 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    if (ode == NULL) return 3;
    ((int (*)(unsigned))dlsym(ode, "dInitODE2"))(0);
    void *const world = ((void *(*)(void))dlsym(ode, "dWorldCreate"))();
    void *const body = ((void *(*)(void *))dlsym(ode, "dBodyCreate"))(world);
    void (*const addForce)(void *, double, double, double) = (void (*)(void *, double, double, double))dlsym(ode, "dBodyAddForce");
    int (*const step)(void *, double) = (int (*)(void *, double))dlsym(ode, "dWorldStep");
    const int isDifferent = argc > 2 && dlsym(ode, "dToggleODE_MT") != NULL;
    for (int i = 1; i <= 10; ++i) {
        addForce(body, i == 7 && isDifferent ? 2 : 1, 0, 0);
        step(world, 0.01);
    }
    ((void (*)(void *))dlsym(ode, "dWorldDestroy"))(world);
    ((void (*)(void))dlsym(ode, "dCloseODE"))();
    return dlclose(ode);
}
