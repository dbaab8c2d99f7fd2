// Where borrowed threads come from: a threading implementation of ODE's, or an executor of the program's (dODE_MT_SetExecutor).
#pragma once

#include <ode/threading.h>

struct dxThreadLender {
    using Work = void (*)(void *data);
    using Executor = void (*)(void *context, Work work, void *data);

    bool isNone() const { return functions == nullptr && executor == nullptr; }

    bool operator==(const dxThreadLender &other) const {
        return functions == other.functions && implementation == other.implementation && executor == other.executor &&
               context == other.context;
    }

    // How many threads serve the implementation. An executor does not tell: the largest number of workers.
    unsigned threads() const;

    // Makes room for calls that wait, of which dxBorrowedThreads has one.
    void prepare() const;

    // Has a thread call call(data, ...) or work(data), whichever the lender knows.
    void post(dThreadedCallFunction *call, Work work, void *data) const;

    const dThreadingFunctionsInfo *functions = nullptr;
    dThreadingImplementationID implementation = nullptr;

    Executor executor = nullptr;
    void *context = nullptr;
};
