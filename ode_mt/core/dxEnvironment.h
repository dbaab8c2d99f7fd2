// The environment variables of the library: one table of names and values, one way to read them, one rule for
// numbers.
//
// A variable that is empty counts as unset. A program that runs with the rights of another user
// (secure_getenv) sees none. docs/settings.md and ode_MT.h repeat the table; a test compares them
// (tests/environment). Any thread may call.
#pragma once

// In the order of need: what most users set comes first, what is for measuring and tests last.
enum class dxVariable {
    Threads,
    Callbacks,
    Solver,
    SolverTolerance,
    WarmStart,
    Log,
    Trace,
    Statistics,
    ThreadManager,
    Perturb,
    Algorithm,
    Heuristics,
    GridCells,
    Workers
};

// Returns its value; NULL: unset or empty.
const char *dxEnvironment(dxVariable variable);

// Calls `tell` for each variable of the process that has a name like the library's, which the library does not read: ODE_MT_THREAD,
// ODEMT_THREADS, ode_mt_threads. `nearest`: the library's name that is meant by the look of it; NULL: none. Those of the loader, the build and
// the tests are not told, nor are empty ones.
void dxTellUnknownVariables(void (*tell)(const char *name, const char *nearest));

// A finite number as strtod reads it in the "C" locale, without blanks. Returns false for anything else.
bool dxReadReal(const char *text, double &number);

enum class dxNumberText { InRange, OutOfRange, NoNumber };

// A number is decimal digits, with a minus in front or not, and nothing else. One that is out of range is
// replaced by the nearest that is in it; what is no number leaves `number` as it is.
dxNumberText dxReadNumber(const char *text, long long least, long long most, long long &number);
