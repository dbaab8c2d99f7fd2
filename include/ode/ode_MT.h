/*************************************************************************
 * ODE_MT: libode that uses every core.                                  *
 *                                                                       *
 * What ODE_MT adds to the API of the Open Dynamics Engine.              *
 * <ode/ode.h> includes this file. A program that calls nothing of it    *
 * gets the same bits as with upstream's library, on one thread, until   *
 * the environment says otherwise (ODE_MT_THREADS).                      *
 *                                                                       *
 * SPDX-License-Identifier: BSD-3-Clause                                 *
 *************************************************************************/
#ifndef _ODE_ODE_MT_H_
#define _ODE_ODE_MT_H_

#include <ode/collision_space.h>
#include <ode/common.h>
#include <ode/odeconfig.h>
#include <ode/threading.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * @defgroup ode_mt Multithreading
 * @brief What ODE_MT adds to ODE.
 *
 * The number of threads, the algorithm and the thread manager change speed, never results: every
 * world gets the bits of upstream's serial step.
 *
 * Environment, for programs that cannot be recompiled. Set before the program starts: each is read once, at the
 * first use of what it is for.
 * @code{.unparsed}
 *   ODE_MT_THREADS=n|auto
 *   ODE_MT_CALLBACKS=serial|concurrent|independent
 *   ODE_MT_SOLVER=exact|fast
 *   ODE_MT_SOLVER_TOLERANCE=x
 *   ODE_MT_WARM_START=0|1
 *   ODE_MT_LOG=error|warning|info|debug
 *   ODE_MT_TRACE=file
 *   ODE_MT_STATISTICS=file
 *   ODE_MT_THREAD_MANAGER=pthread|openmp
 *   ODE_MT_PERTURB=n
 *   ODE_MT_ALGORITHM=auto|serial|lcp|original|static|static-unmerged|duplication|decluster
 *   ODE_MT_HEURISTICS=default|none|NAME,NAME...
 *   ODE_MT_GRID_CELLS=n|auto
 *   ODE_MT_WORKERS=none|mpi|mpi:n
 * @endcode
 * What a user needs first comes first: ODE_MT_THREADS=auto is enough for most programs. docs/settings.md has the table of all
 * settings.
 *
 * An empty variable counts as unset; a program with another user's rights (set-user-ID) reads none. A whole number out
 * of range is replaced by the nearest valid one, any other invalid value by the default, and a line on stderr reports it. A
 * call below overrides the environment.
 *
 * A threading implementation given to dWorldSetStepThreadingImplementation lends its threads to that
 * world's steps instead of the process's own, whatever the number set here; one that has a single thread, or none,
 * keeps the world's steps on one thread, and functions of the user's in it get all calls that ODE itself would make. For collisions, and for
 * all worlds at once, a program lends its threads with dODE_MT_SetExecutor or dODE_MT_SetThreadingImplementation.
 *
 * A NULL for a geom, body, space or world, or for the place of results, ends in dDebug, as elsewhere in ODE, unless a
 * function says otherwise.
 *
 * Threads: a function may be called from any thread at any time, callbacks included, and does not block, unless it says
 * otherwise. Settings of the process take effect at the next step or collision.
 *
 * @since 0.9.0, unless a function says otherwise
 */

/**
 * Version of ODE_MT whose header this is, beside that of ODE (dODE_VERSION): a new first number where a program must be changed, a
 * new second one where something is added. Until 1.0.0 a new second number may mean either. docs/changelog.md lists them.
 * @ingroup ode_mt
 */
#define dODE_MT_VERSION "0.9.0"

/** The same as a number, 10000 first + 100 second + third, for the preprocessor. @ingroup ode_mt */
#define dODE_MT_VERSION_NUMBER 900

/** Number of threads that stands for one thread for every core that this process may use. @ingroup ode_mt */
#define dODE_MT_AUTO 0x7fffffff

/** Largest number of threads. @ingroup ode_mt */
#define dODE_MT_MAX_THREADS 1024

/**
 * Tells the version of the library that is loaded, which may be newer than the header.
 *
 * A program that also runs on upstream's library asks dCheckConfiguration("ODE_EXT_mt"), which is 1 here and 0 there, and finds the
 * functions of this header by dlsym.
 *
 * @return dODE_MT_VERSION of its build, valid until the library is unloaded. dODE_MT_GetUpstreamVersion tells the release of ODE.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetVersion(void);

/**
 * Tells which release of ODE the library that is loaded is made of. dODE_VERSION is that of the header that a program was compiled
 * with: the two may differ, since libode.so.8 is the name of the library in several releases.
 *
 * @return dODE_VERSION of its build, such as "0.16.6", valid until the library is unloaded.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetUpstreamVersion(void);

/**
 * Sets how many threads a step may use, the calling thread included.
 *
 * @param numThreads 0: serial (the default); 1: the calling thread alone; n: up to n threads, used
 *        where the cost model finds that they pay; dODE_MT_AUTO: one for every core.
 *        Any other number is reported with dMessage: a number below 0 counts as 0, one above
 *        dODE_MT_MAX_THREADS as that maximum.
 *
 * May be called from any thread at any time, callbacks of all kinds included; it does not block. A step or collision
 * in progress may continue with the old number. dODE_MT_AUTO counts the cores anew at each call: those that the process was
 * given when it loaded the library and those that its first thread or the calling one may use now, not only those in
 * the affinity mask of the calling thread. Threads start with the first step or collision that uses them and end with dCloseODE. Those
 * of the manager "pthread" may use all of these cores, with ordinary scheduling, unless dODE_MT_SetWorkerAffinity and
 * dODE_MT_SetWorkerPriority say otherwise; the runtime of "openmp" has rules of its own (OMP_PROC_BIND), by default those of the thread that
 * starts them.
 * @ingroup ode_mt
 */
ODE_API void dToggleODE_MT(int numThreads);

/**
 * Tells how many threads a step may use.
 *
 * @return the number in force, from 0 to dODE_MT_MAX_THREADS, dODE_MT_AUTO resolved.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetThreads(void);

/**
 * Sets how many threads the steps of a world may use, in place of the process's number (dToggleODE_MT). A limit of the world's
 * (dWorldSetStepIslandsProcessingMaxThreadCount) holds as well, and where a threading implementation serves the world, there are no more
 * than its threads.
 *
 * May be called from any thread, but not while the world is stepped. The number ends with the world.
 *
 * @param world the world
 * @param numThreads 0: as the process (the default); 1: the calling thread alone; n, dODE_MT_AUTO, and numbers out of range as with
 *        dToggleODE_MT
 * @return 1, or 0 and a dMessage if there is no memory, or if a worker's hook asks for another number.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorldThreads(dWorldID world, int numThreads);

/**
 * Tells how many threads the steps of a world may use: its own number, or else the process's.
 *
 * @param world the world
 * @return the number in force, from 0 to dODE_MT_MAX_THREADS, dODE_MT_AUTO resolved.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetWorldThreads(dWorldID world);

/**
 * Sets how many threads dSpaceCollide of a space may use, in place of the process's number (dToggleODE_MT). Spaces in it have numbers of
 * their own.
 *
 * May be called from any thread, but not while the space collides. The number ends with the space.
 *
 * @param space the space
 * @param numThreads as with dODE_MT_SetWorldThreads
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_SetSpaceThreads(dSpaceID space, int numThreads);

/**
 * Tells how many threads dSpaceCollide of a space may use: its own number, or else the process's.
 *
 * @param space the space
 * @return the number in force, from 0 to dODE_MT_MAX_THREADS, dODE_MT_AUTO resolved.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetSpaceThreads(dSpaceID space);

/**
 * Chooses the algorithm by its name: "auto" (islands in parallel where that pays), "serial" (all
 * islands in order on the calling thread), "lcp" (islands in parallel whenever there are two); or one that
 * does that and finds pairs by clusters of geoms (docs/clusters.md): "original", "static", "static-unmerged",
 * "duplication", "decluster".
 *
 * @param name one of these, in lower case; NULL counts as unknown
 * @return 1, or 0 and a dMessage naming the known ones if there is no such algorithm.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetAlgorithm(const char *name);

/**
 * Tells which algorithm is in force.
 *
 * @return its name, in memory of the library's that is never freed.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetAlgorithm(void);

/**
 * Chooses how the islands of a world are solved: "exact" (the default, unless the environment says otherwise: upstream's algorithms,
 * with upstream's bits) or "fast" (the same equations of the same joints, solved in another way).
 *
 * dWorldStep, "fast": hundreds of times faster for large islands (docs/fast.md). Velocities are those of "exact" to about nine
 * digits wherever the equations determine them well (docs/contracts.md, F2). Forces of redundant joints and contacts (dJointFeedback)
 * may be distributed in another way where cfm is 0.
 *
 * dWorldQuickStep, "fast": sweeps begin with three quarters of the forces of the last step, and solve sixteen pairs of bodies at a time
 * (docs/fast.md). The number of iterations (dWorldSetQuickStepNumIterations) is an upper bound; the result is another approximation
 * than upstream's of the same solution. No random numbers are drawn.
 *
 * The bits are other ones than upstream's, the same for every number of threads and instruction set. Both solvers are the same for
 * worlds stepped by functions of the user's own (dWorldSetStepThreadingImplementation) on one thread.
 *
 * May be called from any thread, but not while the world is stepped. The choice ends with the world.
 *
 * @param world the world
 * @param name "exact" or "fast"; NULL counts as unknown
 * @return 1, or 0 and a dMessage: naming the known ones if there is no such solver, or if there is no memory.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetSolver(dWorldID world, const char *name);

/**
 * Tells which solver a world has: its own choice, or else the process's.
 *
 * @param world the world
 * @return the name of the solver, in memory of the library's that is never freed.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetSolver(dWorldID world);

/**
 * Says how early dWorldQuickStep of a "fast" world may end: before the number of iterations is reached, but after two fifths of it, as
 * soon as a sweep changes the forces by no more than this part of what they change in all (both in terms of energy, the square root of
 * it). 0: not before they change no more. The default is 1e-9. Impulses of contacts are found in single precision, so where bodies slide,
 * a tolerance below 1e-4 ends nothing.
 *
 * May be called from any thread, but not while the world is stepped.
 *
 * @param world the world
 * @param tolerance from 0 to 1, a ratio
 * @return 1, or 0 and a dMessage if the tolerance is another number (NaN included), or if there is no memory.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetSolverTolerance(dWorldID world, double tolerance);

/**
 * Tells the tolerance of a world.
 *
 * @param world the world
 * @return the tolerance, from 0 to 1.
 * @ingroup ode_mt
 */
ODE_API double dODE_MT_GetSolverTolerance(dWorldID world);

/**
 * Says whether dWorldQuickStep of a "fast" world begins with the forces of the world's last step (1, the default), or with none (0). With
 * none, a step depends on nothing but what the program can read and set, so that a world that is made anew from a saved state goes on with the
 * same bits; more iterations are needed for the same residual.
 *
 * May be called from any thread, but not while the world is stepped. A dMessage reports if there is no memory.
 *
 * @param world the world
 * @param isWarm 0: with none; any other number: with those of the last step
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_SetWarmStart(dWorldID world, int isWarm);

/**
 * Tells whether steps of a world begin with the forces of the last one.
 *
 * @param world the world
 * @return 1 if they do, or else 0.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetWarmStart(dWorldID world);

/**
 * Says whether near-callbacks may run on several threads at once: "serial" (the default; one at a time, in
 * upstream's order, on the thread that called dSpaceCollide), "concurrent" (the program consents: callbacks
 * of pairs that share no body run at the same time on any thread) or "independent" (any callbacks do).
 *
 * With either policy a callback may read any body and joint, the geoms of the space that is being collided, and others that have
 * not moved since the last query of their pose and box (upstream computes these at the first query, which two
 * callbacks must not make at once); call dCollide for its pair (for others, too, but not where
 * the collider calls the program or writes to a geom: docs/callbacks.md), dSpaceCollide2 on nested spaces that it was
 * called for, and make contact joints and attach them. With "concurrent" it may also enable the bodies of its pair, and
 * write to data of its pair's bodies. Contact joints appear in the lists of world and bodies only after the
 * last callback, in upstream's order, so the results are upstream's as long as no callback reads those lists
 * (dAreConnected, dBodyGetJoint) to find contacts of the same call. It must not change geoms or spaces, nor write to or free the
 * vertices, points or height samples that geoms use, make other joints, destroy joints, or leave by longjmp; an exception
 * is passed on after all callbacks have ended, and so is pthread_exit, which then ends the thread that called
 * dSpaceCollide (with the manager "pthread"; the runtime of "openmp" does not allow it). It may end the process. A
 * callback has the stack of its thread: at least 8 MiB with "pthread" (unless dODE_MT_SetWorkerStackSize says otherwise), what the
 * runtime gives with "openmp".
 *
 * With "serial" a callback may write to such arrays, as with upstream: contacts with meshes and with height fields that
 * were built without a copy of their samples are then computed in the callback, not before it by several threads. If
 * a program has much terrain of this kind, "concurrent" is faster.
 *
 * @param name "serial", "concurrent" or "independent"; NULL counts as unknown
 * @return 1, or 0 and a dMessage naming the known ones if there is no such policy.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetCallbackPolicy(const char *name);

/**
 * Tells which callback policy is in force.
 *
 * @return its name, in memory of the library's that is never freed.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetCallbackPolicy(void);

/**
 * Tells which of the workers calls: the index of a buffer that a near-callback has for itself, whatever the policy and the thread manager.
 *
 * Callbacks of one dSpaceCollide that run at the same time have different indices, from 0 to dODE_MT_GetWorkerCount - 1. The thread that
 * called dSpaceCollide has 0. Another thread may have another index in the next call, as workers count in the order in which they
 * come. Two calls of dSpaceCollide at the same time both count from 0.
 *
 * @return the index; 0 also with the policy "serial", and outside of near-callbacks.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetWorkerIndex(void);

/**
 * Tells how many buffers the near-callbacks of a space need: an upper bound for dODE_MT_GetWorkerIndex in the next dSpaceCollide, unless
 * a near-callback of another space makes that call (the other space's number holds then), as long as no setting changes until then.
 * dODE_MT_MAX_THREADS is one for all spaces and settings.
 *
 * @param space the space
 * @return the number, from 1 on.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetWorkerCount(dSpaceID space);

/**
 * Chooses the heuristics that tune clusters (docs/clusters.md), for measuring: "default", "none", or names with
 * commas between them: "cells" (number of cells), "centre" (of the grid), "crossover" and "declustering" (checks
 * that are skipped where nothing can have collided or separated), "threads" (no more threads for concurrent
 * callbacks than clusters; not in "default"). They change speed, never results. Takes effect at the next
 * dSpaceCollide of each space.
 *
 * @param names one of these, or several with commas between them; NULL counts as unknown
 * @return 1, or 0 and a dMessage naming the known ones if a name is unknown.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetHeuristics(const char *names);

/**
 * Tells which heuristics are in force.
 *
 * @return their names with commas between them, or "none", in memory of the library's that is never freed.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetHeuristics(void);

/**
 * Sets how many cells the grid of the clustered algorithms has on each axis, to measure its effect.
 *
 * @param cells 5 to 20; 0 (the default): tuned by measured time.
 * @return 1, or 0 and a dMessage naming the known ones if it is another number.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetGridCells(int cells);

/**
 * Tells how many cells are set.
 *
 * @return the number that was set, 0 if it is tuned.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetGridCells(void);

/**
 * Chooses the thread manager by its name, "pthread" or "openmp". May be called at any time, as dToggleODE_MT; a step or
 * collision in progress may continue with the old one. "openmp" loads the OpenMP runtime of the compiler (libgomp.so.1; libomp.so.5 in
 * a build by clang), which stays in memory until the process ends. Threads of the program's own (dODE_MT_SetExecutor) are given back.
 *
 * @param name "pthread" or "openmp" (known where the build found OpenMP); NULL counts as unknown
 * @return 1, or 0 and a dMessage naming the known ones if there is no such manager, or the runtime if it cannot be loaded, or saying that
 * "openmp" cannot start workers as dODE_MT_SetWorkerName and its like ask for.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetThreadManager(const char *name);

/**
 * Tells which thread manager is in force. Where ODE_MT_THREAD_MANAGER asks for "openmp", the runtime is loaded when the first workers are
 * needed; if it cannot be, that is reported, and from then on "pthread" is in force.
 *
 * @return its name, or "user" while threads of the program's own are lent, in memory of the library's that is never freed.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetThreadManager(void);

/** Work that a program's executor is given. @param data as given to the executor @ingroup ode_mt */
typedef void dODE_MT_Work(void *data);

/**
 * An executor: has another thread of the program call work(data), once, and returns without waiting for that. Workers call it too, several
 * of them at the same time perhaps. It must not throw.
 *
 * @param context as given to dODE_MT_SetExecutor
 * @param work the function to be called; it does not throw
 * @param data its argument
 * @ingroup ode_mt
 */
typedef void dODE_MT_PostFunction(void *context, dODE_MT_Work *work, void *data);

/**
 * Has threads of the program's own serve as workers, in place of those of a thread manager: in collisions, and in steps of all worlds but
 * those that have a threading implementation of their own. How many work at the same time is said as before, by dToggleODE_MT and its
 * like; as many threads should be free. No bit changes.
 *
 * Nothing waits for a thread that has not come: the calling thread does what is left. A thread that comes works for a step or a collision,
 * and for those that follow within 50 microseconds, and returns. At most one piece of work waits to be called at any time. Callbacks of the
 * policies "concurrent" and "independent" run on these threads too, in their stacks.
 *
 * May be called from any thread. A step or collision in progress may continue with the old threads. Otherwise they have left the library
 * when this function, dODE_MT_SetThreadManager or dCloseODE returns; it waits up to a second for work that was not called yet, which
 * finds nothing to do when it is called later. A child of fork works alone until it calls this function itself.
 *
 * @param post the executor; NULL: the thread manager of before
 * @param context given to it
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_SetExecutor(dODE_MT_PostFunction *post, void *context);

/**
 * The same with a threading implementation of ODE's, as dWorldSetStepThreadingImplementation has it, for the process: no more of its threads
 * work at the same time than serve it, the calling one counted as one of them. It must be taken back before it is freed.
 *
 * @param functions the functions of the implementation; NULL: the thread manager of before
 * @param implementation the implementation; NULL if functions is NULL
 * @return 1, or 0 and a dMessage if only one of the two is NULL.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetThreadingImplementation(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation);

/**
 * Names the threads of the manager "pthread", as debuggers, top and the time line show them: NAME-1, NAME-2 and so on.
 *
 * This and the functions that follow say how workers are started. They end the present ones; the next step or collision that needs
 * workers starts new ones. Threads of the program's own (dODE_MT_SetExecutor) stay as they are, and so do those of "openmp", which belong to
 * its runtime: while that is in force these functions are refused, and it is refused after one of them. OMP_PROC_BIND, OMP_PLACES and
 * OMP_STACKSIZE are its settings.
 *
 * @param name 1 to 10 characters; NULL: "ode_mt", the default
 * @return 1, or 0 and a dMessage if the name is too long or empty, or if the manager is "openmp".
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorkerName(const char *name);

/**
 * Says on which processors workers may run. The number of threads stays as it is: dODE_MT_AUTO counts the processors of the process. A hook
 * (dODE_MT_SetWorkerHooks) can bind each worker to a processor of its own.
 *
 * @param processors their numbers, as sched_setaffinity has them
 * @param count how many; 0: all that the process may use, the default
 * @return 1, or 0 and a dMessage with the reason if the system does not allow it, or if the manager is "openmp".
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorkerAffinity(const int *processors, int count);

/**
 * Says how the system schedules workers. The thread that calls a step works too and stays as it is.
 *
 * @param scheduling "normal" or "batch", where priority is the niceness, from -20 to 19; "idle", where it is 0; "fifo" or "round-robin",
 *        where it is from 1 to 99; NULL: the default, "normal" with the niceness of the process's first thread
 * @param priority see there; ignored if scheduling is NULL
 * @return 1, or 0 and a dMessage with the reason if the system does not allow it (most of it needs a privilege), or if the manager is
 * "openmp".
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorkerPriority(const char *scheduling, int priority);

/** Least size of a worker's stack, in bytes. @ingroup ode_mt */
#define dODE_MT_MIN_STACK_SIZE 65536

/**
 * Sets the size of the workers' stacks. The library itself takes about 20 KB of them; what concurrent near-callbacks take comes on top. Memory
 * is used as far as it is written.
 *
 * @param bytes at least dODE_MT_MIN_STACK_SIZE, rounded up to whole pages; 0: 8 MiB, or the system's default where that is larger
 * @return 1, or 0 and a dMessage with the reason if the system does not allow it, or if the manager is "openmp".
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorkerStackSize(size_t bytes);

/**
 * A function that a worker calls when it starts or ends. It must not throw, leave by longjmp, end its thread, or wait for a thread that ends
 * workers. It may call any function of ODE but those that end workers, which are refused then with a dMessage, those that set another number
 * of threads among them; steps and collisions in it run on one thread.
 *
 * @param data as given to dODE_MT_SetWorkerHooks
 * @param worker the number of the thread, from 1 on, as in its name; dODE_MT_GetWorkerIndex is another one
 * @ingroup ode_mt
 */
typedef void dODE_MT_WorkerHook(void *data, int worker);

/**
 * Sets what each worker calls on its own thread: before its first work, and after its last one. So a program can register its threads with a
 * profiler, bind them, or keep something for each of them.
 *
 * Workers end by dCloseODE, when their number or the way they start changes, and when the library is unloaded; not where the process ends
 * before, and not in a child of fork, in which there are none until it starts some of its own. Until they have ended the functions must
 * stay loaded.
 *
 * @param start called first; NULL: nothing
 * @param end called last; NULL: nothing
 * @param data given to both
 * @return 1, or 0 and a dMessage if the manager is "openmp".
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_SetWorkerHooks(dODE_MT_WorkerHook *start, dODE_MT_WorkerHook *end, void *data);

/**
 * Steps many worlds, with the bits that calls of dWorldStep or dWorldQuickStep for one after the other would give, random numbers and the
 * order in which spaces hear of moved geoms included. Threads share the worlds out, each of them stepped as a whole by one thread; the number
 * of threads is the process's (dToggleODE_MT), and threads are used where they pay.
 *
 * On the calling thread alone, in their place among the others, are stepped: a world with a moved-callback, with memory functions of the
 * program's, with a threading implementation or a number of threads of its own; and one that takes so long that its islands are better shared out.
 * All worlds are while the program has a handler of errors or messages or an allocator of its own. Worlds that share working memory are stepped one
 * after the other.
 *
 * May be called from any thread, also at the same time for other worlds. As with dWorldStep, no other thread may use one of these worlds, or a
 * space that holds their geoms, meanwhile. A joint cannot connect bodies of two worlds (dJointAttach). An error in one of the worlds ends in
 * dError or dDebug when all before it have been stepped.
 *
 * @param worlds the worlds, each of them once
 * @param count how many; 0: nothing happens
 * @param stepper "step" (dWorldStep) or "quick" (dWorldQuickStep); NULL counts as unknown
 * @param stepSize as with these functions; above 0
 * @return 1, or 0: with a dMessage, and no world has been stepped, if there is no such stepper, if the count is below 0, if a world stands in the
 * list twice, or if there is no memory for the list; or if there was no memory to step a world, and all others have been stepped.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_StepWorlds(const dWorldID *worlds, int count, const char *stepper, dReal stepSize);

/**
 * Counters of parallel work since the process started. Each call below returns the low 32 bits of a member, which
 * wrap (a scene of thousands of bodies has a million pairs in a second); differences of two readings remain correct.
 * @ingroup ode_mt
 */
typedef struct dODE_MT_Statistics {
    unsigned long long parallelSteps;       /**< dODE_MT_GetParallelSteps */
    unsigned long long parallelIslands;     /**< dODE_MT_GetParallelIslands */
    unsigned long long teamSteps;           /**< dODE_MT_GetTeamSteps */
    unsigned long long parallelCollisions;  /**< dODE_MT_GetParallelCollisions */
    unsigned long long sharedCollisions;    /**< dODE_MT_GetSharedCollisions */
    unsigned long long contactsAhead;       /**< dODE_MT_GetContactsAhead */
    unsigned long long contactsAheadUnused; /**< dODE_MT_GetContactsAheadUnused */
} dODE_MT_Statistics;

/**
 * Writes the counters in 64 bits each.
 *
 * @param statistics where they are written; NULL is reported with dMessage
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_GetStatistics(dODE_MT_Statistics *statistics);

/**
 * Counts the steps whose islands ran on several threads.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetParallelSteps(void);

/**
 * Counts the islands stepped in those steps.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetParallelIslands(void);

/**
 * Counts the steps in which at least two threads stepped one large island together.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetTeamSteps(void);

/**
 * Counts the calls of dSpaceCollide whose callbacks ran on at least two threads.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetParallelCollisions(void);

/**
 * Counts the calls of dSpaceCollide in which at least two threads computed boxes, found pairs, or computed contacts
 * before the callbacks; the callbacks were called one at a time.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetSharedCollisions(void);

/**
 * Counts the pairs of geoms whose contacts were computed before their near-callback, for dCollide to return.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetContactsAhead(void);

/**
 * Counts those of these pairs whose callback did not ask for the contacts, or asked for others.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetContactsAheadUnused(void);

/**
 * Counts the islands that the solver "fast" was asked to solve.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetDirectIslands(void);

/**
 * Counts those of these islands that it left to the algorithm of "exact", since it found no solution, or no good one, and those whose rows
 * contradict one another or nearly repeat one another, for which it has forces that leave little of them.
 *
 * @return the number since the process started.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetDirectFallbacks(void);

/**
 * Tells how many threads were ever used at once.
 *
 * @return the largest number of threads that took part in one parallel step or in the callbacks of one collision; 0 if
 * there was none.
 * @ingroup ode_mt
 */
ODE_API unsigned dODE_MT_GetMaxWorkersUsed(void);

/**
 * Says whether steps note which thread steps each body, for dODE_MT_GetBodyWorker, as a replay shows it (docs/tools.md). It costs a write to each
 * body in a step. No result changes.
 *
 * @param isNoted 1, or 0 (the default)
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_NoteBodyWorkers(int isNoted);

/**
 * Tells which thread has stepped a body in the last step of its world, if that was noted. Which one it is may differ from run to run, unlike all
 * results.
 *
 * @param body must exist. A call while its world is stepped tells nothing
 * @return 0: the thread that called the step, also for an island that several threads have stepped together; n: worker n, below
 *         dODE_MT_GetThreads(); -1: none, as the body slept or was made after the step, or as nothing was noted.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetBodyWorker(dBodyID body);

/**
 * Why a part of a frame ran on one thread. Later versions may have more reasons; numbers do not change.
 * @ingroup ode_mt
 */
typedef enum dODE_MT_Reason {
    dODE_MT_REASON_PARALLEL = 0,         /**< it did not: several threads took part */
    dODE_MT_REASON_NOTHING = 1,          /**< there was nothing to do: no collision, or no body that moves */
    dODE_MT_REASON_THREADS = 2,          /**< the number of threads is 0 or 1 (dToggleODE_MT, ODE_MT_THREADS) */
    dODE_MT_REASON_ALGORITHM = 3,        /**< the algorithm is "serial" */
    dODE_MT_REASON_CORES = 4,            /**< the process may use one core */
    dODE_MT_REASON_WORLD_LIMIT = 5,      /**< dWorldSetStepIslandsProcessingMaxThreadCount allows one thread */
    dODE_MT_REASON_USER_THREADING = 6,   /**< the world's own threading implementation has one thread */
    dODE_MT_REASON_FLOAT_TRAPS = 7,      /**< the program has floating-point errors trapped (feenableexcept) */
    dODE_MT_REASON_SMALL_ISLAND = 8,     /**< there is one island, too small for several threads */
    dODE_MT_REASON_ITERATIONS = 9,       /**< the number of iterations is above 100000 */
    dODE_MT_REASON_COST = 10,            /**< several threads are predicted to take longer */
    dODE_MT_REASON_LARGE_ISLAND = 11,    /**< one island is nearly all there is, and several threads take longer for it */
    dODE_MT_REASON_MOVED_CALLBACK = 12,  /**< a body with a moved-callback is in one of the first islands */
    dODE_MT_REASON_LATE_WORKERS = 13,    /**< the calling thread was done before another one came */
    dODE_MT_REASON_MEMORY = 14,          /**< there was no memory for more */
    dODE_MT_REASON_FEW_GEOMS = 15,       /**< the space has too few geoms */
    dODE_MT_REASON_MEASURED = 16,        /**< several threads have not been measured to be faster */
    dODE_MT_REASON_IN_CALLBACK = 17,     /**< the collision was called by a near-callback of another one */
    dODE_MT_REASON_CALLBACK_POLICY = 18, /**< the callback policy is "serial" (dODE_MT_SetCallbackPolicy) */
    dODE_MT_REASON_FEW_TASKS = 19,       /**< few pairs, or most of them share bodies, so that their callbacks may not run at once */
    dODE_MT_REASON_FEEDBACK = 20,        /**< joints of one of the first islands share a dJointFeedback with those of another */
    dODE_MT_REASON_WORLDS = 21           /**< it was stepped beside other worlds, as a whole by one thread (dODE_MT_StepWorlds) */
} dODE_MT_Reason;

/**
 * Says what a reason means.
 *
 * @param reason a dODE_MT_Reason
 * @return half a sentence in English, as "the number of threads is 0 or 1", in memory of the library's that is never freed; "unknown
 * reason" for any other number.
 * @ingroup ode_mt
 */
ODE_API const char *dODE_MT_GetReasonText(int reason);

/**
 * The last frame of a world. A frame is what happens from the end of one step of the world to the end of the next: a step, and the
 * collisions before it. A collision is a call of dSpaceCollide that no near-callback makes; it belongs to the world of the first body
 * found in the space, and is the calls that near-callbacks make in it. dSpaceCollide2 and dCollide by themselves are not seen.
 *
 * Units: seconds of the clock, as the thread sees them that calls collision and step. Later versions may add members at the end.
 * @ingroup ode_mt
 */
typedef struct dODE_MT_WorldStatistics {
    size_t size;           /**< in: sizeof(dODE_MT_WorldStatistics); out: how many bytes have been written */
    unsigned number;       /**< of the world, in the order of their first recorded steps, from 1 */
    unsigned threads;      /**< that steps of the world may use (dODE_MT_GetWorldThreads) */
    unsigned bodies;       /**< of the world, those that sleep included */
    unsigned contacts;     /**< contact joints of the world */
    unsigned islands;      /**< that were stepped; "fast" counts small ones of dWorldQuickStep together */
    unsigned collisions;   /**< in the frame */
    unsigned collisionThreads;  /**< most that took part in one of the stages of one of the collisions; 0: no collision */
    unsigned stepThreads;       /**< most that took part in one of the stages of the step */
    int collisionReason;   /**< dODE_MT_Reason: why pairs were found, and contacts computed, on one thread (the last collision) */
    int callbackReason;    /**< dODE_MT_Reason: why near-callbacks ran on one thread (the same) */
    int stepReason;        /**< dODE_MT_Reason: why the step ran on one thread */
    unsigned reserved;     /**< 0 */
    unsigned long long rows;   /**< of the constraints; 0 where functions of the user's step the world; "fast": three a contact */
    unsigned long long pairs;  /**< of geoms for which near-callbacks were called */
    unsigned long long contactsAhead;        /**< those of them whose contacts were computed before (narrow-phase prefetch) */
    unsigned long long contactsAheadUnused;  /**< those of these that were not asked for, or changed */
    double hitRate;         /**< part of these that was asked for, from 0 to 1; 0 if there were none */
    double frameTime;       /**< the whole frame, the program's own code included; 0 for the first */
    double collisionTime;   /**< all collisions */
    double broadPhaseTime;  /**< of these: boxes, pairs and their order */
    double callbackTime;    /**< of these: near-callbacks, with contacts computed before them */
    double prefetchTime;    /**< of these: contacts computed before them */
    double stepTime;        /**< the step */
    double islandSearchTime;       /**< of this: bodies fall asleep, islands are found */
    double islandPreparationTime;  /**< of this: before islands are stepped side by side */
    double islandsTime;            /**< of this: islands */
    double commitTime;             /**< of this: after islands were stepped side by side */
    double waitTime;        /**< of the frame: the calling thread has nothing to do but to wait for others */
    unsigned long long frames;              /**< since the world has been recorded, as all that follows */
    unsigned long long parallelSteps;       /**< steps in which several threads took part */
    unsigned long long parallelCollisions;  /**< collisions in which several threads took part */
    unsigned long long allCollisions;       /**< collisions */
    double allFrameTime;      /**< sum of frameTime */
    double allCollisionTime;  /**< sum of collisionTime */
    double allStepTime;       /**< sum of stepTime */
    unsigned remoteWorkers;      /**< of the process, at the end of the step: as dODE_MT_RemoteStatistics has it */
    unsigned remoteWorkersLost;  /**< the same */
    unsigned remoteIslands;      /**< of the islands: solved by workers in other processes */
    unsigned returnedIslands;    /**< of the islands: sent to such workers, and solved at home after all */
    unsigned long long allRemoteIslands;    /**< sum of remoteIslands */
    unsigned long long allReturnedIslands;  /**< sum of returnedIslands */
    double sharedTime;   /**< of collisions and step: the calling thread is in stages that several threads may share */
    double workTime;     /**< what all threads do in these stages, added up; waits between the phases of a sweep are in it */
    double serialShare;  /**< part of the work of collisions and step that the calling thread does outside of these, from 0 to 1: with N threads they
                              take at least serialShare + (1 - serialShare) / N of the time (Amdahl's law). 1 if nothing was shared */
} dODE_MT_WorldStatistics;

/**
 * Tells how the last frame of a world went. The first call makes the library record frames, of all worlds, from then on; ODE_MT_LOG=info or
 * debug and ODE_MT_STATISTICS do so from the beginning. Until then nothing is recorded, so that a first call is answered by 0. No result changes.
 *
 * May be called from any thread. It does not wait for a step in progress.
 *
 * @param world the world
 * @param statistics where they are written; its member size says how much room there is
 * @return 1, or 0 if no frame of the world has been recorded; the rest of the members is 0 then. A size below that of the first two members is
 * reported with dMessage, and answered by 0.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetWorldStatistics(dWorldID world, dODE_MT_WorldStatistics *statistics);

/**
 * Workers in other processes (ODE_MT_WORKERS), and the islands of dWorldStep that were sent to them, since the process started; what is sent and not
 * counted below that is under way, or of a step that ended early. Later versions may add members at the end.
 * @ingroup ode_mt
 */
typedef struct dODE_MT_RemoteStatistics {
    size_t size;               /**< in: sizeof(dODE_MT_RemoteStatistics); out: how many bytes have been written */
    unsigned workers;          /**< that take part now */
    unsigned workersLate;      /**< of these: get nothing for the moment, as they are late, or were just now */
    unsigned workersRefused;   /**< at their start: their version, precision or arithmetic is another one */
    unsigned workersLost;      /**< were disconnected, or sent what cannot be */
    unsigned workersReplaced;  /**< of these: by new ones */
    unsigned timesLate;        /**< how often a worker was late */
    unsigned long long islandsSent;       /**< to workers */
    unsigned long long islandsSolved;     /**< by them */
    unsigned long long islandsSooner;     /**< at home after all: it had nothing left to do, and was predicted to be sooner */
    unsigned long long islandsLate;       /**< at home after all: their worker was late */
    unsigned long long islandsLost;       /**< at home after all: their worker was lost */
    unsigned long long islandsGivenBack;  /**< at home after all: their worker reported an error, or had no memory, or there was none for a message */
} dODE_MT_RemoteStatistics;

/**
 * Tells what workers in other processes have done. May be called from any thread at any time; a process that has none gets zeros.
 *
 * @param statistics where they are written; its member size says how much room there is
 * @return 1, or 0 with a dMessage if the size is below that of the first two members.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_GetRemoteStatistics(dODE_MT_RemoteStatistics *statistics);

/**
 * Starts to record what each thread does in steps and collisions, for a file that https://ui.perfetto.dev and chrome://tracing
 * open (docs/tools.md). ODE_MT_TRACE does the same from the first step or collision on, unless the program has started or stopped a trace before.
 * No result changes.
 *
 * The last 8192 events of each thread are kept in memory, half a MiB a thread. The file is written by dODE_MT_FlushTrace, dODE_MT_StopTrace
 * and dCloseODE, when the process ends by exit, or when the library is unloaded; each time anew, with all events that are kept. A process that
 * ends in another way leaves what was written before. A trace that is being recorded is stopped first, as by dODE_MT_StopTrace. After fork the
 * child records nothing until it starts a trace of its own. The call waits while the file is written.
 *
 * @param path of the file, relative to the folder that is the process's own now; it is replaced. "%p" in it stands for the number of the process
 * @return 1, or 0 and a dMessage with the reason if the file cannot be written; nothing is recorded then.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_StartTrace(const char *path);

/**
 * Writes the file of the trace with all that has been recorded, and goes on recording. The call waits until the file is written.
 *
 * @return 1, or 0 if nothing is recorded, or if the file cannot be written, which a dMessage reports.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_FlushTrace(void);

/**
 * Asks for the same. The file is written at the beginning of the next step, on the thread that makes it. May be called by a handler of
 * a signal (it is async-signal-safe). Nothing happens if nothing is recorded then.
 *
 * @ingroup ode_mt
 */
ODE_API void dODE_MT_RequestTraceFlush(void);

/**
 * Writes the file of the trace and ends the recording; what was recorded is forgotten. The call waits until the file is written.
 *
 * @return 1, or 0 if nothing was recorded, or if the file cannot be written, which a dMessage reports.
 * @ingroup ode_mt
 */
ODE_API int dODE_MT_StopTrace(void);

/* ------------------------------------------------------------------------------------------------
 * Calls that programs written for the multithreaded ODE of Webots make. ODE_MT works on the user's
 * own world, space and geoms and never copies or hides one, so most of these have little to do.
 * ------------------------------------------------------------------------------------------------ */

/**
 * A stepper: dWorldStep, dWorldQuickStep or the user's own.
 *
 * @param world the world to be stepped
 * @param stepsize by how much time, above 0
 * @return what the stepper returns; it is not looked at.
 * @ingroup ode_mt
 */
typedef int dWorldStepFunction(dWorldID world, dReal stepsize);

/**
 * A function that is called between step and collide.
 *
 * @param threadID -1: the thread that called dWorldStepAndSpaceCollide; no other number is given.
 * @ingroup ode_mt
 */
typedef void dSpaceUpdateFunction(int threadID);

/**
 * One frame: dSpaceCollide(space, data, callback), then stepper(world, stepsize).
 * Callbacks are called as by dSpaceCollide (dODE_MT_SetCallbackPolicy). It may be called from where both may be called, and a NULL
 * for anything but the data ends in dDebug.
 *
 * @param space the space to be collided
 * @param data given to the callback
 * @param callback the near-callback
 * @param world the world to be stepped
 * @param stepsize the time of the step, above 0
 * @param stepper the stepper, called on this thread
 * @ingroup ode_mt
 */
ODE_API void dSpaceCollideAndWorldStep(dSpaceID space, void *data, dNearCallback *callback, dWorldID world,
                                       dReal stepsize, dWorldStepFunction *stepper);

/**
 * One frame: stepper(world, stepsize), then update(-1) unless update is NULL, then
 * dSpaceCollide(space, data, callback). It may be called from where both may be called, and a NULL for anything but data and update ends
 * in dDebug.
 *
 * @param space the space to be collided
 * @param data given to the callback
 * @param callback the near-callback
 * @param world the world to be stepped
 * @param stepsize the time of the step, above 0
 * @param stepper the stepper, called on this thread
 * @param update called on this thread; NULL: none
 * @ingroup ode_mt
 */
ODE_API void dWorldStepAndSpaceCollide(dSpaceID space, void *data, dNearCallback *callback, dWorldID world,
                                       dReal stepsize, dWorldStepFunction *stepper,
                                       dSpaceUpdateFunction *update);

/**
 * Has no effect: geoms are never copied, so none needs to be distinguished.
 *
 * @param geom a geom
 * @ingroup ode_mt
 */
ODE_API void dGeomSetDynamicFlag(dGeomID geom);

/**
 * Compares two handles.
 *
 * @param g1 a geom, or NULL
 * @param g2 a geom, or NULL
 * @return 1 if both handles are the same geom, or both NULL, else 0.
 * @ingroup ode_mt
 */
ODE_API int dAreGeomsSame(dGeomID g1, dGeomID g2);

/**
 * Has no effect: parameters are read from the user's world at every step.
 *
 * @param world a world
 * @ingroup ode_mt
 */
ODE_API void dWorldRefreshParameters(dWorldID world);

/**
 * Tells how many spaces a thread handles in the update call of dWorldStepAndSpaceCollide.
 *
 * @param threadID what the update call was given
 * @return 1 (the user's own space) for threadID -1 during a frame of that function or of dSpaceCollideAndWorldStep on the
 * calling thread, else 0.
 * @ingroup ode_mt
 */
ODE_API int dThreadGetSpacesCount(int threadID);

/**
 * Tells which these spaces are.
 *
 * @param threadID what the update call was given
 * @param index from 0 to dThreadGetSpacesCount - 1
 * @return the index-th of those spaces, or NULL if there is none.
 * @ingroup ode_mt
 */
ODE_API dSpaceID dThreadGetSpaceID(int threadID, int index);

/**
 * @defgroup ode_mt_clusters Clusters, for a debug overlay
 * @brief Where pairs are looked for, to be drawn.
 *
 * A space has clusters while an algorithm that clusters is in force (dODE_MT_SetAlgorithm). They are those of the last check
 * in dSpaceCollide: at each call without heuristics, else where geoms could have collided or separated
 * (docs/clusters.md), so cells may be those of some calls before.
 * The functions change nothing. They must not be called from another thread while the space collides. `world` is the
 * world whose bodies the geoms of the space have. A cluster has a name, a number from 1 on, that it keeps from
 * frame to frame; 0 stands for no cluster. Functions that write up to `capacity` of something only count where that is 0;
 * their array may be NULL then.
 *
 * @since 0.9.0, unless a function says otherwise
 */

/**
 * Counts the dynamic clusters of a space.
 *
 * @param world the world
 * @param space the space
 * @return the number of dynamic clusters; 1 if the space has no clusters, as all geoms count as one.
 * @ingroup ode_mt_clusters
 */
ODE_API int dClusterGetCount(dWorldID world, dSpaceID space);

/**
 * Tells how large a grid cell is.
 *
 * @param world the world
 * @param space the space
 * @return the edge of a grid cell, in the program's unit of length; 0 without a grid.
 * @ingroup ode_mt_clusters
 */
ODE_API float dClusterGetGridStep(dWorldID world, dSpaceID space);

/**
 * Writes the centre of the grid, the origin without a grid.
 *
 * @param world the world
 * @param space the space
 * @param x where its first coordinate is written
 * @param y where its second one is written
 * @param z where its third one is written
 * @ingroup ode_mt_clusters
 */
ODE_API void dClusterGetCenter(dWorldID world, dSpaceID space, float *x, float *y, float *z);

/**
 * Tells how many cells the grid has on each axis.
 *
 * @param world the world
 * @param space the space
 * @return that number, 0 without a grid.
 * @ingroup ode_mt_clusters
 */
ODE_API int dClusterGetGridCells(dWorldID world, dSpaceID space);

/**
 * Tells which cluster a geom, or the space around it, is in.
 *
 * @param geom the geom
 * @return the name of the cluster; 0: the geom is static, big, or in none.
 * @ingroup ode_mt_clusters
 */
ODE_API unsigned dClusterGetOfGeom(dGeomID geom);

/**
 * Tells which cluster of static geoms a static geom, or the space around it, is in. Such clusters have no names: the number may be
 * another in the next frame.
 *
 * @param geom the geom
 * @return the number of that cluster, from 1 on; 0: in none.
 * @ingroup ode_mt_clusters
 */
ODE_API unsigned dClusterGetStaticOfGeom(dGeomID geom);

/**
 * Tells with which clusters a geom, or the space around it, is tested: its own, or all near which the algorithm looks for a static
 * one.
 *
 * @param geom the geom
 * @param clusters where their names are written
 * @param capacity how many of them at most
 * @return how many there are.
 * @ingroup ode_mt_clusters
 */
ODE_API int dClusterGetTestedWith(dGeomID geom, unsigned *clusters, int capacity);

/**
 * Tells which cluster a body is in.
 *
 * @param body the body
 * @return the name of the cluster of the body's first geom, 0 if it has none.
 * @ingroup ode_mt_clusters
 */
ODE_API unsigned dClusterGetOfBody(dBodyID body);

/** A cell that a dynamic geom occupied at the last check of the clusters. @ingroup ode_mt_clusters */
typedef struct dClusterCell {
    int x;            /**< from 0 to dClusterGetGridCells - 1 */
    int y;            /**< from 0 to dClusterGetGridCells - 1 */
    int z;            /**< from 0 to dClusterGetGridCells - 1 */
    unsigned cluster; /**< name */
} dClusterCell;

/**
 * Tells which cells are occupied.
 *
 * @param world the world
 * @param space the space
 * @param cells where they are written, in no order
 * @param capacity how many of them at most
 * @return how many there are.
 * @ingroup ode_mt_clusters
 */
ODE_API int dClusterGetCells(dWorldID world, dSpaceID space, dClusterCell *cells, int capacity);

/** A merge or a split of clusters in the last dSpaceCollide. @ingroup ode_mt_clusters */
typedef struct dClusterEvent {
    int isSplit;         /**< 0: `from` became part of `into`; 1: `into` separated from `from` */
    unsigned from;       /**< name of the cluster that is no more, or that the other one left */
    unsigned into;       /**< name of the cluster that remains, or that is new */
} dClusterEvent;

/**
 * Tells what happened to the clusters in the last dSpaceCollide.
 *
 * @param world the world
 * @param space the space
 * @param events where merges and splits are written
 * @param capacity how many of them at most
 * @return how many there were.
 * @ingroup ode_mt_clusters
 */
ODE_API int dClusterGetEvents(dWorldID world, dSpaceID space, dClusterEvent *events, int capacity);

#ifdef __cplusplus
}

/**
 * The form with references that callers written in C++ for Webots use.
 *
 * @param world the world
 * @param space the space
 * @param x the first coordinate of the centre of the grid
 * @param y the second one
 * @param z the third one
 * @ingroup ode_mt_clusters
 */
inline void dClusterGetCenter(dWorldID world, dSpaceID space, float &x, float &y, float &z) {
    dClusterGetCenter(world, space, &x, &y, &z);
}
#endif

#endif
