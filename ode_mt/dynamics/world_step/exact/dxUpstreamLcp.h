// Upstream's LCP solver and what it works with. Its headers do not include what they use: the order matters.
#pragma once

#include "config.h"

#include "error.h"
#include "util.h"

#include "lcp.h"
#include "matrix.h"
