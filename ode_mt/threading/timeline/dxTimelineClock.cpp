#include "threading/timeline/dxTimelineClock.h"

namespace {

// Intel's and AMD's manuals: CPUID 80000007h, EDX bit 8, "invariant TSC".
bool hasInvariantCounter() {
#if defined(__x86_64__)
    unsigned a, b, c, d;
    return __get_cpuid(0x80000007, &a, &b, &c, &d) != 0 && (d & 1u << 8) != 0;
#else
    return false;
#endif
}

}  // namespace

const bool dxTimelineClock::s_hasCounter = hasInvariantCounter();
