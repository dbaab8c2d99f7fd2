// Remote workers that are threads of this process: each runs a dxRemoteServer at its end of a link of two queues. What workers send can be
// delayed, damaged, held back or cut off, message by message. A worker that ends without memory is reported as a link that is lost. The link can be
// a simulated one, and what workers do recorded.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "remote/transport/dxRemoteFrame.h"
#include "remote/worker/dxRemoteServer.h"
#include "remote/transport/dxRemoteTransport.h"
#include "remote/worker/dxWorkerArguments.h"

struct LoopbackFate {
    enum class Kind { Arrives, Flipped, Stopped, Dies };

    Kind kind = Kind::Arrives;
    std::chrono::microseconds delay{0};
    unsigned bit = 0;  // which one is flipped, modulo the size
};

// Of workers for tests.
dxRemoteHello helloOf(const char *version);

class LoopbackTransport final : public dxRemoteTransport {
public:
    // What becomes of a message that the worker sends; `count`: how many it has sent before. On the worker's thread.
    using Fate = std::function<LoopbackFate(unsigned worker, unsigned count, dxRemoteKind kind)>;

    LoopbackTransport(unsigned workers, const dxRemoteHello &hello, dxRemoteServer::Solve solve, Fate fate = nullptr,
                      const dxWorkerArguments &arguments = {});
    ~LoopbackTransport() override;

    unsigned links() const override { return static_cast<unsigned>(m_workers.size()); }
    bool isForAllThreads() const override { return true; }
    bool send(unsigned link, const void *message, std::size_t bytes) override;
    std::size_t waiting(unsigned &link) override;
    bool receive(void *message) override;
    void close(bool isOrderly) override;

    // Lost workers are replaced from now on.
    void setReplacing() { m_isReplacing = true; }
    bool canReplace() const override { return m_isReplacing; }
    void replace(unsigned link) override;
    Replacement replacement() override;

private:
    struct Queue {
        std::mutex mutex;
        std::deque<dxRemoteBytes> messages;
    };
    struct Worker;

    void start(Worker &worker, unsigned index);
    void endWorkers();

    const dxRemoteHello m_hello;
    const dxRemoteServer::Solve m_solve;
    const Fate m_fate;
    const dxWorkerArguments m_arguments;
    bool m_isReplacing = false;
    unsigned m_replacedLink = 0;
    std::vector<std::unique_ptr<Worker>> m_workers, m_replaced;
    dxRemoteBytes m_message;
    unsigned m_next = 0;
};
