// Steps worlds whose matrices are singular on the libode.so.8 that the loader finds, and prints for each its
// messages and the state of its bodies, bit by bit. The first line names the library.
#include "motor_world.h"

#include <dlfcn.h>

#include <cmath>
#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

using namespace singular;

constexpr int worldsOfPush = 4000, steps = 6;

// Handlers get no argument of the user's.
std::string g_messages;
std::jmp_buf g_end;

void note(int, const char *format, va_list arguments) {
    char text[300];
    std::vsnprintf(text, sizeof(text), format, arguments);
    // The line of an assertion is not compared (docs/exactness.md).
    g_messages.append(text, std::strcspn(text, "[")).append("; ");
}

void noteAndEnd(int number, const char *format, va_list arguments) {
    note(number, format, arguments);
    std::longjmp(g_end, 1);
}

// All NaNs are one.
void tell(const dReal *vector) {
    for (int i = 0; i < 3; ++i) {
        unsigned long long bits = 0;
        std::memcpy(&bits, &vector[i], sizeof(dReal));
        std::isnan(vector[i]) ? std::printf(" nan") : std::printf(" %llx", bits);
    }
}

// An assertion ends it: upstream cannot step or destroy such a world.
bool run(MotorWorld &world) {
    if (setjmp(g_end) != 0) return false;
    for (int i = 0; i < steps; ++i) {
        world.push();
        world.step();
        g_messages += "| ";
    }
    return true;
}

void tellWorld(Push push, int seed) {
    auto *const world = new MotorWorld(push, seed);
    g_messages.clear();
    const bool isWhole = run(*world);
    std::printf("%s %d: %s", nameOf(push), seed, g_messages.c_str());
    if (isWhole) {
        for (dBodyID body : world->bodies()) {
            tell(dBodyGetPosition(body));
            tell(dBodyGetLinearVel(body));
            tell(dBodyGetAngularVel(body));
        }
        delete world;
    }
    std::printf("\n");
}

}  // namespace

int main() {
    Dl_info info;
    std::printf("%s\n", dladdr(dlsym(RTLD_DEFAULT, "dWorldStep"), &info) != 0 ? info.dli_fname : "none");
    dInitODE2(0);
    dSetMessageHandler(note);
    dSetDebugHandler(noteAndEnd);
    for (Push push : allPushes)
        for (int seed = 0; seed < worldsOfPush; ++seed) tellWorld(push, seed);
    std::fflush(stdout);
    std::_Exit(0);  // worlds left half way are not taken apart
}
