#include "dxThreadCreation.h"

#include <signal.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <vector>

#include "trace/dxLog.h"

namespace {

class Attributes {
public:
    Attributes() {
        pthread_attr_init(&attributes);
        std::size_t size = 0;
        pthread_attr_getstacksize(&attributes, &size);
        pthread_attr_setstacksize(&attributes, std::max(size, std::size_t{8} << 20));
    }
    ~Attributes() { pthread_attr_destroy(&attributes); }
    const pthread_attr_t *get() const { return &attributes; }

private:
    pthread_attr_t attributes;
};

// A new thread inherits the signal mask of its creator.
class BlockedSignals {
public:
    BlockedSignals() {
        sigset_t blocked;
        sigfillset(&blocked);
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT})
            sigdelset(&blocked, fault);
        pthread_sigmask(SIG_SETMASK, &blocked, &before);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }

private:
    sigset_t before;
};

void *waitForGate(void *gate) {
    const std::lock_guard<std::mutex> pass(*static_cast<std::mutex *>(gate));
    return nullptr;
}

}  // namespace

int dxStartThread(dxCreateThread create, pthread_t &thread, void *(*body)(void *), void *context) {
    const Attributes attributes;
    const BlockedSignals blocked;
    return create(&thread, attributes.get(), body, context);
}

unsigned dxProbeThreads(dxCreateThread create, unsigned wanted, int &refusal) {
    std::vector<pthread_t> threads;
    threads.reserve(wanted);
    std::mutex gate;
    {
        const std::lock_guard<std::mutex> closed(gate);
        refusal = 0;
        while (threads.size() < wanted) {
            pthread_t thread;
            refusal = dxStartThread(create, thread, waitForGate, &gate);
            if (refusal != 0) break;
            threads.push_back(thread);
        }
    }
    for (const pthread_t thread : threads) pthread_join(thread, nullptr);
    return static_cast<unsigned>(threads.size());
}

void dxReportRefusal(const char *manager, unsigned workers, unsigned wanted, int refusal) {
    dxLog(dxLogLevel::warning,
          "thread manager %s: the system refused a thread (%s); %u of %u workers, the caller included, are "
          "used",
          manager, std::strerror(refusal), workers, wanted);
}
