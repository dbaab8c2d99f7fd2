#include "collision/narrowphase/dxSilentChanges.h"

std::atomic<std::uint64_t> dxSilentChanges::changes{0};
