/* What upstream's configure script finds out, for the configuration of Debian's libode8 on Linux:
 * atomics from OU, built-in thread pool, no thread-local storage, asserts on. Precision, OU,
 * OPCODE and libccd are compile definitions (ode/CMakeLists.txt), as in upstream's own build. */
#ifndef ODE_MT_CONFIG_H
#define ODE_MT_CONFIG_H

#include <alloca.h>
#include <inttypes.h>
#include <malloc.h>
#include <stdint.h>

#define HAVE_DLFCN_H 1
#define HAVE_GETTIMEOFDAY 1
#define HAVE_PTHREAD_ATTR_SETINHERITSCHED 1
#define HAVE_PTHREAD_CONDATTR_SETCLOCK 1

#if defined(__x86_64__)
#define X86_64_SYSTEM 1
#endif

#define dOU_ENABLED 1
#define dATOMICS_ENABLED 1
#define dBUILTIN_THREADING_IMPL_ENABLED 1

#include "typedefs.h"

#endif
