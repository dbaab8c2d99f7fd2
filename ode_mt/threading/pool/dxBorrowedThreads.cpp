#include "threading/pool/dxBorrowedThreads.h"

#include <algorithm>

#include "threading/pool/dxSpin.h"
#include "threading/pool/dxThreadCreation.h"

dxBorrowedThreads::dxBorrowedThreads(const dThreadingFunctionsInfo *info, dThreadingImplementationID impl)
    : most(dxMaxWorkers), functions(info), implementation(impl) {
    functions->preallocate_resources_for_calls(implementation, std::max(threads(), 1u));
}

unsigned dxBorrowedThreads::threads() const { return functions->retrieve_thread_count(implementation); }

void dxBorrowedThreads::requestWorkers(unsigned wanted) {
    if (searching.load() < wanted) post();
}

void dxBorrowedThreads::release() {
    if (references.fetch_sub(1) == 1) delete this;
}

void dxBorrowedThreads::abandon() {
    board.abandon();
    references.store(1);
    searching.store(0);
    waiting.store(true);
}

void dxBorrowedThreads::post() {
    if (waiting.exchange(true)) return;
    ++references;
    functions->post_call(implementation, nullptr, nullptr, 0, nullptr, nullptr, call, this, 0,
                         "ODE_MT worker");
}

int dxBorrowedThreads::call(void *context, dcallindex_t, dCallReleaseeID) {
    dxBorrowedThreads *borrowed = static_cast<dxBorrowedThreads *>(context);
    borrowed->serve();
    borrowed->release();
    return 1;
}

// A call counts as searching before `waiting` falls, and stops counting before its last look at the
// board, so a run that relies on it is seen by it.
void dxBorrowedThreads::serve() {
    const auto hasWork = [this] { return board.hasWork(); };
    const auto joined = [this] {
        if (--searching == 0 && board.hasWork()) post();
    };
    ++searching;
    waiting.store(false);
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
