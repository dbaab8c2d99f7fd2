// The world's own arena for the time of a step: memory that a user's manager (dWorldSetStepMemoryManager) gave, on the thread
// that called the step.
#pragma once

#include "dynamics/step/islands/dxIsland.h"

class dxWorldArena {
public:
    explicit dxWorldArena(dxWorld *world)
        : m_context(world->unsafeGetWorldProcessingContext()), m_arena(m_context->ObtainStepperMemArena()) {}
    ~dxWorldArena() { m_context->ReturnStepperMemArena(m_arena); }
    dxWorldArena(const dxWorldArena &) = delete;
    dxWorldArena &operator=(const dxWorldArena &) = delete;

    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessContext *m_context;
    dxWorldProcessMemArena *m_arena;
};
