#include "threading/dxUpstreamScope.h"

namespace {
// One pointer per thread. The initial-exec model makes reading it one instruction; a library loaded
// with dlopen may use the few bytes of static thread storage that glibc keeps for this.
__attribute__((tls_model("initial-exec"))) thread_local dxUpstreamScope *t_current = nullptr;
}  // namespace

dxUpstreamScope::dxUpstreamScope() : m_outer(t_current) { t_current = this; }

void dxUpstreamScope::leave() {
    if (m_entered) t_current = m_outer;
    m_entered = false;
}

dxUpstreamScope *dxUpstreamScope::current() { return t_current; }
