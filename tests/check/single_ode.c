/* The least of a libode.so.8 that has single precision. */
#include <stddef.h>

static int world;

int dCheckConfiguration(const char *name) { return name == NULL; }
int dInitODE2(unsigned flags) { return flags == 0; }
void dCloseODE(void) {}
void *dWorldCreate(void) { return &world; }
void dWorldDestroy(void *destroyed) { (void)destroyed; }
void *dBodyCreate(void *of) { return of; }
void dBodyAddForce(void *body, float x, float y, float z) { (void)body, (void)x, (void)y, (void)z; }
const float *dBodyGetPosition(void *body) {
    (void)body;
    return NULL;
}
int dWorldStep(void *stepped, float stepSize) { return stepped == &world && stepSize == 0.0f; }
