// The name under which dxSharingPolicy is used by the step and the solvers.
#pragma once

#include "threading/dxSharingPolicy.h"

using dxSharingPace = dxSharingPolicy;
