#include "threading/managers/dxThreadManagerUser.h"

#include <algorithm>
#include <chrono>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "threading/pool/dxJobBoard.h"
#include "threading/pool/dxSpin.h"
#include "threading/pool/dxWorkerThread.h"

unsigned dxThreadLender::threads() const {
    return executor != nullptr ? kMaxWorkers : functions->retrieve_thread_count(implementation);
}

void dxThreadLender::prepare() const {
    if (executor == nullptr) functions->preallocate_resources_for_calls(implementation, std::max(threads(), 1u));
}

void dxThreadLender::post(dThreadedCallFunction *call, Work work, void *data) const {
    if (executor != nullptr)
        executor(context, work, data);
    else
        functions->post_call(implementation, nullptr, nullptr, 0, nullptr, nullptr, call, data, 0, "ODE_MT worker");
}

// The state that the manager and the calls it posted share.
class dxThreadManagerUser::Calls final : public dxWorkerSource {
public:
    Calls(const dxThreadLender &lender, bool isServed) : limit(kMaxWorkers), m_lender(lender), m_isAbandoned(!isServed) {
        if (isServed) m_lender.prepare();
    }

    unsigned threads() const { return m_lender.threads(); }

    void requestWorkers(unsigned wanted) override {
        if (m_searching.load() < wanted) post();
    }

    // Returns the number of calls posted that have not returned yet.
    unsigned outstanding() const { return m_isAbandoned.load() ? 0 : m_references.load() - 1; }

    // Gives the manager's reference or a call's back; the last one deletes the object.
    void release() {
        if (m_references.fetch_sub(1) == 1) delete this;
    }

    // Requires a forked child, in which no thread is inside. The waiting call is a part of the program's memory, which may still make it.
    void abandon() {
        board.abandon();
        m_references.store(m_isWaiting.load() ? 2 : 1);
        m_searching.store(0);
        m_isAbandoned.store(true);
    }

    dxJobBoard board;
    std::atomic<unsigned> limit;  // upper bound for the workers of a run, and for those of all runs

private:
    ~Calls() = default;

    // Calls that are inside look at the board before they return.
    void post() {
        if (m_isAbandoned.load() || m_isWaiting.exchange(true)) return;
        if (m_references.load() >= limit.load()) {
            m_isWaiting.store(false);
            return;
        }
        ++m_references;
        m_lender.post(call, work, this);
    }

    static int call(void *calls, dcallindex_t, dCallReleaseeID) {
        work(calls);
        return 1;
    }

    static void work(void *context);
    void serve();

    const dxThreadLender m_lender;
    std::atomic<unsigned> m_references{1};  // the manager, and every call not yet returned
    std::atomic<unsigned> m_searching{0};   // calls that will look at the board before they return
    std::atomic<bool> m_isWaiting{false};   // a posted call has not been made
    std::atomic<bool> m_isAbandoned;        // calls are not posted, and not waited for
};

// A callback may end the thread: the reference is given back by whatever way the call is left. A call counts as searching before m_isWaiting becomes
// false. One that is made once too often finds it false, and has no reference to give back.
void dxThreadManagerUser::Calls::work(void *context) {
    Calls &own = *static_cast<Calls *>(context);
    ++own.m_searching;
    if (!own.m_isWaiting.exchange(false)) {
        --own.m_searching;
        return;
    }
    struct Return {
        Calls &calls;
        ~Return() { calls.release(); }
    };
    const Return atEnd{own};
    own.serve();
}

// A call stops counting as searching before its last look at the board, so a run that relies on it is seen by it.
void dxThreadManagerUser::Calls::serve() {
    const auto hasWork = [this] { return board.hasWork(); };
    const auto joined = [this] {
        if (--m_searching == 0 && board.hasWork()) post();
    };
    for (;;) {
        const bool maySpin = m_searching.load() < dxProcessorCount();
        if (maySpin ? dxSpinUntil(hasWork) : hasWork()) {
            if (board.work(joined)) ++m_searching;
        } else {
            --m_searching;
            if (!hasWork()) return;
            ++m_searching;
        }
    }
}

dxThreadManagerUser::dxThreadManagerUser(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation)
    : dxThreadManagerUser(dxThreadLender{functions, implementation}) {}

dxThreadManagerUser::dxThreadManagerUser(const dxThreadLender &lender, bool isServed) : m_calls(new Calls(lender, isServed)) {
    listenToForks();
}

dxThreadManagerUser::~dxThreadManagerUser() {
    ignoreForks();
    stop();
    m_calls->release();
}

unsigned dxThreadManagerUser::workers() const { return std::min(m_calls->limit.load(), dxClampWorkers(m_calls->threads())); }

void dxThreadManagerUser::resize(unsigned workers) { m_calls->limit.store(dxClampWorkers(workers)); }

unsigned dxThreadManagerUser::limit() const { return m_calls->limit.load(); }

void dxThreadManagerUser::run(unsigned blocks, unsigned maxWorkers, Task task, void *context) {
    const unsigned most = std::min({maxWorkers, blocks, workers()});
    if (most < 2) {
        dxRunAlone(blocks, task, context);
    } else {
        m_calls->board.run({blocks, most - 1, task, context}, *m_calls);
    }
}

void dxThreadManagerUser::stop() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (!idle()) {
        if (std::chrono::steady_clock::now() > end) {
            // An implementation may make calls only where a thread waits for them, and none does here. The work was done without it.
            dxLog(dxLogLevel::Info, "thread manager user: the threading implementation has not run %u call(s)", m_calls->outstanding());
            return;
        }
        dxSleep(std::chrono::microseconds(50));
    }
}

bool dxThreadManagerUser::idle() const { return m_calls->outstanding() == 0; }

void dxThreadManagerUser::inForkedChild() { m_calls->abandon(); }
