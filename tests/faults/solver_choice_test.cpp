// A world's solver that cannot be noted for want of memory: the choice is refused and reported, the world keeps the one it has, and the
// next choice is taken.
#include "failing_memory.h"

#include <gtest/gtest.h>

#include <ode/ode.h>
#include <ode/ode_MT.h>

#include <cstdarg>
#include <cstdio>
#include <string>

namespace {

char g_message[200];

void keepMessage(int, const char *format, va_list arguments) { std::vsnprintf(g_message, sizeof g_message, format, arguments); }

template <class Call>
void expectReport(const Call &call) {
    g_message[0] = '\0';
    faults::arm(faults::Source::operatorNew, 0, faults::Shortage::lasting);
    call();
    faults::disarm();
    EXPECT_EQ(std::string(g_message), "ODE_MT: no memory to note the solver of a world");
}

TEST(SolverChoice, WithoutMemoryIsRefusedAndReported) {
    dInitODE2(0);
    dSetMessageHandler(keepMessage);
    const dWorldID world = dWorldCreate();
    faults::arm(faults::Source::operatorNew, 0, faults::Shortage::lasting);
    const int refused = dODE_MT_SetSolver(world, "fast");
    const long requests = faults::disarm();
    EXPECT_EQ(refused, 0);
    EXPECT_GT(requests, 0);
    EXPECT_EQ(std::string(g_message), "ODE_MT: no memory to note the solver of a world");
    expectReport([world] { EXPECT_EQ(dODE_MT_SetSolverTolerance(world, 0.5), 0); });
    expectReport([world] { dODE_MT_SetWarmStart(world, 0); });
    EXPECT_NE(dODE_MT_GetSolverTolerance(world), 0.5);
    EXPECT_EQ(dODE_MT_GetWarmStart(world), 1);
    EXPECT_STREQ(dODE_MT_GetSolver(world), "exact");
    EXPECT_EQ(dODE_MT_SetSolver(world, "fast"), 1);
    EXPECT_STREQ(dODE_MT_GetSolver(world), "fast");
    dWorldDestroy(world);
    dSetMessageHandler(nullptr);
    dCloseODE();
}

}  // namespace
