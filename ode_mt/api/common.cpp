// Functions of ode/common.h: what this build of the library can do.
#include <ode/common.h>

#include <cstring>

#include "seams/upstream.h"

// dGetConfiguration is upstream's: programs may compare its text with that of the libode they know.
extern "C" int dCheckConfiguration(const char *token) {
    return dxUpstreamCheckConfiguration(token) != 0 || std::strcmp(token, "ODE_EXT_mt") == 0 ? 1 : 0;
}
