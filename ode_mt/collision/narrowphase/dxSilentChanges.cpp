#include "collision/narrowphase/dxSilentChanges.h"

dxEventCounter dxSilentChanges;
