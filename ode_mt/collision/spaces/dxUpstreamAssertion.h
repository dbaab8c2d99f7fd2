// Assertions of upstream's that ours raise in its place, with its text, file and line.
#pragma once

#include <ode/error.h>

#include "config.h"
#include "error.h"

// `line`: of seams/assertions.h.
[[noreturn]] inline void dxFailUpstreamAssertion(const char *assertion, const char *function, const char *file, unsigned line) {
    dDebug(d_ERR_IASSERT, "assertion \"%s\" failed in %s() [%s:%u]", assertion, function, file, line);
}
