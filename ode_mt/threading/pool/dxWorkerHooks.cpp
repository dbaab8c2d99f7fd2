#include "threading/pool/dxWorkerHooks.h"

namespace {

__attribute__((tls_model("initial-exec"))) thread_local bool t_isInside = false;

}  // namespace

bool dxWorkerHooks::isInside() { return t_isInside; }

dxWorkerHookScope::dxWorkerHookScope(const dxWorkerHooks &hooks, unsigned worker) : m_hooks(hooks), m_worker(static_cast<int>(worker)) {
    call(m_hooks.start);
}

dxWorkerHookScope::~dxWorkerHookScope() { call(m_hooks.end); }

void dxWorkerHookScope::call(dxWorkerHooks::Hook hook) const {
    if (hook == nullptr) return;
    t_isInside = true;
    hook(m_hooks.data, m_worker);
    t_isInside = false;
}
