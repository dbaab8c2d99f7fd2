// The state shared by dxThreadManagerUser and the calls it posted; see there for the protocol.
#pragma once

#include <ode/threading.h>

#include "threading/pool/dxJobBoard.h"

class dxBorrowedThreads final : public dxWorkerSource {
public:
    dxBorrowedThreads(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation);

    unsigned threads() const;
    void requestWorkers(unsigned wanted) override;

    // Calls posted that have not returned yet.
    unsigned outstanding() const { return references.load() - 1; }

    // The manager's end of use; the last reference deletes the object.
    void release();

    // Requires a forked child, in which no thread is inside and no call will be executed.
    void abandon();

    dxJobBoard board;
    std::atomic<unsigned> most;  // upper bound for the workers of a run

private:
    ~dxBorrowedThreads() = default;

    void post();
    static int call(void *borrowed, dcallindex_t, dCallReleaseeID);
    void serve();

    const dThreadingFunctionsInfo *const functions;
    const dThreadingImplementationID implementation;
    std::atomic<unsigned> references{1};  // the manager, and every call not yet returned
    std::atomic<unsigned> searching{0};   // calls that will look at the board before they return
    std::atomic<bool> waiting{false};     // a posted call has not been taken up
};
