// Functions of ode/ode_MT.h that programs written for the multithreaded ODE of Webots call.
//
// There, clusters live in hidden worlds and spaces and hold copies of static geoms, and callers have to
// know. Here there is one world, one space and the user's own geoms.
#include <ode/collision.h>
#include <ode/error.h>
#include <ode/ode_MT.h>

#include "threading/dxStackFrame.h"

namespace {

// The space of the frame in progress on this thread, for dThreadGetSpaceID in the update call.
class FrameSpace {
public:
    [[gnu::always_inline]] explicit FrameSpace(dSpaceID space) : m_outer(t_current) {
        t_current = {space, dxStackFrame::ofCaller()};
    }
    ~FrameSpace() { t_current = m_outer; }
    FrameSpace(const FrameSpace &) = delete;
    FrameSpace &operator=(const FrameSpace &) = delete;

    // NULL: there is no such frame, or it was left by a jump.
    static dSpaceID current() {
        return t_current.frame.called(dxStackFrame::ofCaller()) ? t_current.space : nullptr;
    }

private:
    struct Current {
        dSpaceID space = nullptr;
        dxStackFrame frame;
    };
    static thread_local Current t_current;

    const Current m_outer;
};
thread_local FrameSpace::Current FrameSpace::t_current;

void require(bool condition, const char *function, const char *what) {
    if (!condition) dDebug(d_ERR_UASSERT, "%s in %s()", what, function);
}

void checkFrame(const char *function, dSpaceID space, dNearCallback *callback, dWorldID world,
                dWorldStepFunction *stepper) {
    require(space != nullptr, function, "bad space argument");
    require(callback != nullptr, function, "bad callback argument");
    require(world != nullptr, function, "bad world argument");
    require(stepper != nullptr, function, "bad stepper argument");
}

}  // namespace

extern "C" {

void dSpaceCollideAndWorldStep(dSpaceID space, void *data, dNearCallback *callback, dWorldID world,
                               dReal stepsize, dWorldStepFunction *stepper) {
    checkFrame(__func__, space, callback, world, stepper);
    const FrameSpace frame(space);
    dSpaceCollide(space, data, callback);
    stepper(world, stepsize);
}

void dWorldStepAndSpaceCollide(dSpaceID space, void *data, dNearCallback *callback, dWorldID world,
                               dReal stepsize, dWorldStepFunction *stepper, dSpaceUpdateFunction *update) {
    constexpr int kCallingThread = -1;
    checkFrame(__func__, space, callback, world, stepper);
    const FrameSpace frame(space);
    stepper(world, stepsize);
    if (update != nullptr) update(kCallingThread);
    dSpaceCollide(space, data, callback);
}

void dGeomSetDynamicFlag(dGeomID geom) { require(geom != nullptr, __func__, "bad geom argument"); }

int dAreGeomsSame(dGeomID g1, dGeomID g2) { return g1 == g2; }

void dWorldRefreshParameters(dWorldID world) { require(world != nullptr, __func__, "bad world argument"); }

int dThreadGetSpacesCount(int threadID) { return threadID == -1 && FrameSpace::current() != nullptr ? 1 : 0; }

dSpaceID dThreadGetSpaceID(int threadID, int index) {
    return index >= 0 && index < dThreadGetSpacesCount(threadID) ? FrameSpace::current() : nullptr;
}

}  // extern "C"
