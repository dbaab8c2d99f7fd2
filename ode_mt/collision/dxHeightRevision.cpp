#include "collision/dxHeightRevision.h"

std::atomic<std::uint64_t> dxHeightRevision::changes{0};
