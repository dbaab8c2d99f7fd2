// The libode.so.8 that the program would call without the observer. It is found at the first call, and stays loaded from then on.
#pragma once

#include <string>

struct dxWorld;
struct dxBody;

namespace observer {

// The functions that the observer stands in front of.
enum class Call { WorldCreate, WorldDestroy, BodyCreate, BodyDestroy, WorldStep, WorldQuickStep };
constexpr int kCalls = 6;
extern const char *const kCallNames[kCalls];

// Reals are handed on as they are, so that a library with single precision works, too: the lower half of the same register.
struct OdeLibrary {
    std::string file;
    bool isOurs = false;
    bool isDouble = false;

    void *calls[kCalls] = {};
    dxWorld *(*bodyGetWorld)(dxBody *) = nullptr;
    const double *(*bodyGetPosition)(dxBody *) = nullptr;
    const double *(*bodyGetQuaternion)(dxBody *) = nullptr;
    const double *(*bodyGetLinearVel)(dxBody *) = nullptr;
    const double *(*bodyGetAngularVel)(dxBody *) = nullptr;
    const double *(*bodyGetForce)(dxBody *) = nullptr;
    const double *(*bodyGetTorque)(dxBody *) = nullptr;
    int (*bodyIsEnabled)(dxBody *) = nullptr;

    template <class Function>
    Function *real(Call call) const {
        return reinterpret_cast<Function *>(calls[static_cast<int>(call)]);
    }
};

// `caller`: an address in the code that calls. Ends the process, with a message, if there is no library.
const OdeLibrary &libraryOf(const void *caller);

// Makes the library that defines `function` the one of this process, unless there is one already. Returns the one of this process.
const OdeLibrary &adoptLibraryOf(void *function);

// Null: there is none that all of the program sees, and none has been found by other ways.
const OdeLibrary *globalLibrary();

// The C library's own; the observer stands in front of it, too.
void *realDlsym(void *handle, const char *name);

}  // namespace observer
