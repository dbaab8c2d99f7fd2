// The environment variables of the library: one table of names and values, one way to read them, one rule for
// numbers.
//
// A variable that is empty counts as unset. A program that runs with the rights of another user
// (secure_getenv) sees none. docs/settings.md and ode_MT.h repeat the table; a test compares them
// (tests/environment).
//
// Threading: any thread.
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

// Returns its value; null: unset or empty.
const char *dxEnvironment(dxVariable variable);

// Calls `report` for each variable of the process that has a name like the library's, but that the library does not read: ODE_MT_THREAD,
// ODEMT_THREADS, ode_mt_threads. `nearest`: the library's name that is probably meant; null: none. Variables of the loader, the build and
// the tests are not reported, nor are empty ones.
void dxReportUnknownVariables(void (*report)(const char *name, const char *nearest));

// Reads a finite number as strtod does in the "C" locale, without blanks. Returns false for anything else.
bool dxReadReal(const char *text, double &number);

enum class dxNumberText { InRange, OutOfRange, NoNumber };

// Reads a whole number: decimal digits, perhaps after a minus, and nothing else. A number that is out of range is
// replaced by the nearest that is in it; `number` is unchanged if the text is no number.
dxNumberText dxReadNumber(const char *text, long long min, long long max, long long &number);
