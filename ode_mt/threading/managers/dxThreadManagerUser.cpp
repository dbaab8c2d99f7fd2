#include "threading/managers/dxThreadManagerUser.h"

#include <algorithm>
#include <chrono>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/pool/dxBorrowedThreads.h"
#include "threading/pool/dxThreadCreation.h"

dxThreadManagerUser::dxThreadManagerUser(const dThreadingFunctionsInfo *functions,
                                         dThreadingImplementationID implementation)
    : dxThreadManagerUser(dxThreadLender{functions, implementation}) {}

dxThreadManagerUser::dxThreadManagerUser(const dxThreadLender &lender, bool isServed) : borrowed(new dxBorrowedThreads(lender, isServed)) {
    listenToForks();
}

dxThreadManagerUser::~dxThreadManagerUser() {
    ignoreForks();
    stop();
    borrowed->release();
}

unsigned dxThreadManagerUser::workers() const {
    return std::min(borrowed->most.load(), dxClampWorkers(borrowed->threads()));
}

void dxThreadManagerUser::resize(unsigned workers) { borrowed->most.store(dxClampWorkers(workers)); }

unsigned dxThreadManagerUser::limit() const { return borrowed->most.load(); }

void dxThreadManagerUser::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, workers()});
    if (most < 2) {
        dxRunAlone(blocks, task, context);
    } else {
        borrowed->board.run({blocks, most - 1, task, context}, *borrowed);
    }
}

void dxThreadManagerUser::stop() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (!idle()) {
        if (std::chrono::steady_clock::now() > end) {
            // An implementation may run calls only where a thread waits for them, and none does here; the work was done
            // without it.
            dxLog(dxLogLevel::info, "thread manager user: the threading implementation has not run %u call(s)",
                  borrowed->outstanding());
            return;
        }
        dxSleep(std::chrono::microseconds(50));
    }
}

bool dxThreadManagerUser::idle() const { return borrowed->outstanding() == 0; }

void dxThreadManagerUser::inForkedChild() { borrowed->abandon(); }
