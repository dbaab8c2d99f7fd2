#include "threading/pool/dxBorrowedThreads.h"

#include "threading/pool/dxSpin.h"
#include "threading/pool/dxThreadCreation.h"

dxBorrowedThreads::dxBorrowedThreads(const dxThreadLender &lends, bool isServed) : most(dxMaxWorkers), lender(lends), isAbandoned(!isServed) {
    if (isServed) lender.prepare();
}

void dxBorrowedThreads::requestWorkers(unsigned wanted) {
    if (searching.load() < wanted) post();
}

void dxBorrowedThreads::release() {
    if (references.fetch_sub(1) == 1) delete this;
}

void dxBorrowedThreads::abandon() {
    board.abandon();
    references.store(waiting.load() ? 2 : 1);
    searching.store(0);
    isAbandoned.store(true);
}

// Calls that are inside look at the board before they return.
void dxBorrowedThreads::post() {
    if (isAbandoned.load() || waiting.exchange(true)) return;
    if (references.load() >= most.load()) {
        waiting.store(false);
        return;
    }
    ++references;
    lender.post(call, work, this);
}

int dxBorrowedThreads::call(void *borrowed, dcallindex_t, dCallReleaseeID) {
    work(borrowed);
    return 1;
}

// Also where a callback ends the thread. A call counts as searching before `waiting` falls. One that is made once too often finds that it has
// fallen, and has no reference to give back.
void dxBorrowedThreads::work(void *context) {
    dxBorrowedThreads &own = *static_cast<dxBorrowedThreads *>(context);
    ++own.searching;
    if (!own.waiting.exchange(false)) {
        --own.searching;
        return;
    }
    struct Return {
        dxBorrowedThreads &borrowed;
        ~Return() { borrowed.release(); }
    };
    const Return atEnd{own};
    own.serve();
}

// A call stops counting as searching before its last look at the board, so a run that relies on it is seen by it.
void dxBorrowedThreads::serve() {
    const auto hasWork = [this] { return board.hasWork(); };
    const auto joined = [this] {
        if (--searching == 0 && board.hasWork()) post();
    };
    for (;;) {
        const bool maySpin = searching.load() < dxProcessorCount();
        if (maySpin ? dxSpinUntil(hasWork) : hasWork()) {
            if (board.work(joined)) ++searching;
        } else {
            --searching;
            if (!hasWork()) return;
            ++searching;
        }
    }
}
