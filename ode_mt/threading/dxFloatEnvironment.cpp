#include "threading/dxFloatEnvironment.h"

#include <fenv.h>

#include <type_traits>

static_assert(std::is_integral_v<std::fexcept_t>, "the saved flags are the FE_ bits themselves");

bool dxTrapsFloatingPoint() { return fegetexcept() > 0; }

void dxFloatEnvironment::capture() {
    std::fegetenv(&m_environment);
    m_raised.store(0, std::memory_order_relaxed);
}

void dxFloatEnvironment::raiseFlags() const {
    const unsigned flags = m_raised.load(std::memory_order_relaxed);
    const unsigned missing = flags & ~static_cast<unsigned>(std::fetestexcept(FE_ALL_EXCEPT));
    if (missing == 0) return;
    const auto saved = static_cast<std::fexcept_t>(missing);
    std::fesetexceptflag(&saved, static_cast<int>(missing));
}

dxFloatEnvironmentScope::dxFloatEnvironmentScope(dxFloatEnvironment &environment) : m_shared(environment) {
    std::fegetenv(&m_own);
    std::fesetenv(&m_shared.m_environment);
    m_known = static_cast<unsigned>(std::fetestexcept(FE_ALL_EXCEPT));
}

dxFloatEnvironmentScope::~dxFloatEnvironmentScope() { std::fesetenv(&m_own); }

void dxFloatEnvironmentScope::shareFlags() {
    const unsigned now = static_cast<unsigned>(std::fetestexcept(FE_ALL_EXCEPT));
    if (now == m_known) return;
    m_shared.m_raised.fetch_or(now, std::memory_order_relaxed);
    m_known = now;
}
