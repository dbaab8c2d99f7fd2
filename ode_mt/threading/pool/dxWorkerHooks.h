// What the program has each worker call when it starts and when it ends (dODE_MT_SetWorkerHooks).
//
// A hook runs on its worker outside of every run, where nothing keeps the manager: ending the workers would have the thread wait
// for itself. So whatever ends workers, or lends them, asks whether the calling thread is in a hook.
#pragma once

struct dxWorkerHooks {
    using Hook = void (*)(void *data, int worker);

    // Whether the calling thread is in one.
    static bool isInside();

    Hook start = nullptr, end = nullptr;
    void *data = nullptr;
};

// Calls the hooks of the calling thread: one when it is made, the other by whatever way the thread leaves its scope.
class dxWorkerHookScope {
public:
    dxWorkerHookScope(const dxWorkerHooks &hooks, unsigned worker);
    ~dxWorkerHookScope();
    dxWorkerHookScope(const dxWorkerHookScope &) = delete;
    dxWorkerHookScope &operator=(const dxWorkerHookScope &) = delete;

private:
    void call(dxWorkerHooks::Hook hook) const;

    const dxWorkerHooks m_hooks;
    const int m_worker;
};
