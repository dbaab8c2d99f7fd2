// The function of ode/ode_MT.h that steps many worlds.
#include <ode/error.h>
#include <ode/ode_MT.h>

#include <new>

#include "config.h"
#include "error.h"

#include "core/dxPointerSet.h"
#include "dynamics/step/dxStepWorlds.h"

namespace {

enum class Check { Fine, Null, Twice, NoMemory };

// `index`: of the first world that is not fine.
Check checkWorlds(const dWorldID *worlds, int count, int &index) try {
    dxPointerSet known;
    for (index = 0; index < count; ++index) {
        if (worlds[index] == nullptr) return Check::Null;
        if (!known.insert(worlds[index])) return Check::Twice;
    }
    return Check::Fine;
} catch (const std::bad_alloc &) {
    return Check::NoMemory;
}

}  // namespace

extern "C" {

int dODE_MT_StepWorlds(const dWorldID *worlds, int count, const char *stepper, dReal stepSize) {
    const char *const name = stepper != nullptr ? stepper : "(null)";
    const dxWorldStepper *const found = dxFindWorldStepper(name);
    if (found == nullptr) {
        dMessage(0, "ODE_MT: no stepper '%.100s'; known: step, quick", name);
        return 0;
    }
    if (count < 0) {
        dMessage(0, "ODE_MT: no list of %d worlds; known: 0 and more", count);
        return 0;
    }
    if (count == 0) return 1;
    dUASSERT(worlds, "bad worlds argument");
    dUASSERT(stepSize > 0, "stepsize must be > 0");
    int index = 0;
    const Check check = checkWorlds(worlds, count, index);
    dUASSERT(check != Check::Null, "bad world argument");
    if (check == Check::Twice) dMessage(0, "ODE_MT: world %d of %d stands in the list before", index, count);
    if (check == Check::NoMemory) dMessage(0, "ODE_MT: no memory to step %d worlds", count);
    if (check != Check::Fine) return 0;
    return dxStepWorlds(worlds, static_cast<unsigned>(count), *found, stepSize) ? 1 : 0;
}

}  // extern "C"
