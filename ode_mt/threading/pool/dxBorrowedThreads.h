// The state shared by dxThreadManagerUser and the calls it posted; see there for the protocol.
#pragma once

#include <ode/threading.h>

#include "threading/pool/dxJobBoard.h"
#include "threading/pool/dxThreadLender.h"

class dxBorrowedThreads final : public dxWorkerSource {
public:
    // Unless the lender serves (a child of fork has no threads of its parent's), every run is done by its caller.
    dxBorrowedThreads(const dxThreadLender &lender, bool isServed);

    unsigned threads() const { return lender.threads(); }
    void requestWorkers(unsigned wanted) override;

    // Calls posted that have not returned yet.
    unsigned outstanding() const { return isAbandoned.load() ? 0 : references.load() - 1; }

    // The manager's end of use; the last reference deletes the object.
    void release();

    // Requires a forked child, in which no thread is inside. The waiting call is a part of the program's memory, which may still call it.
    void abandon();

    dxJobBoard board;
    std::atomic<unsigned> most;  // upper bound for the workers of a run, and for those of all runs

private:
    ~dxBorrowedThreads() = default;

    void post();
    static int call(void *borrowed, dcallindex_t, dCallReleaseeID);
    static void work(void *borrowed);
    void serve();

    const dxThreadLender lender;
    std::atomic<unsigned> references{1};  // the manager, and every call not yet returned
    std::atomic<unsigned> searching{0};   // calls that will look at the board before they return
    std::atomic<bool> waiting{false};     // a posted call has not been taken up
    std::atomic<bool> isAbandoned;        // calls are not posted, and not waited for
};
