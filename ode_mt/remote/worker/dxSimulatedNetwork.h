// A network between a worker and the coordinator that is slower than the one that is there: what a transport carries arrives
//
//   delay + bytes / bandwidth          after it was sent, in both directions, each of which is busy for bytes / bandwidth,
//
// so that what a step costs on a cluster can be tried on one machine. A message that comes from the coordinator is taken to have been sent
// between the two looks of which the second one found it.
//
// Messages are carried by whoever looks, one at a time: the worker's own thread whenever it asks what is waiting and between two problems
// (carrying()), and a thread of this object's, which makes the transport below and closes it, sleeps until something is due, and looks seldom
// while the worker's does. Where the transport below is for one thread only, that thread carries all. Sleeps are as exact as the system's
// timers.
//
// Why two: one of its own alone found no core where the coordinator and the worker keep one each busy, and was milliseconds late; the worker's
// alone would let a result wait for the next problem, which may take 0.1 s.
//
// Units: ns. Threading: that of a transport; the thread below is internal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "remote/transport/dxPollPause.h"
#include "remote/transport/dxRemoteFrame.h"
#include "remote/worker/dxRemoteServer.h"
#include "remote/transport/dxRemoteTransport.h"

struct dxSimulatedLink {
    static constexpr double kMaxDelayNs = 1e9;  // what takes longer is lost for the handshake

    double delayNs = 0;    // one way
    double nsPerByte = 0;  // 0: as many bytes at a time as are wanted

    bool isThere() const { return delayNs > 0 || nsPerByte > 0; }
};

class dxSimulatedNetwork final : public dxRemoteTransport {
public:
    // While the worker looks, the thread does so seldom, in case it does not any more.
    static constexpr std::chrono::microseconds kBesideWorker{400};

    using Open = std::function<std::unique_ptr<dxRemoteTransport>(std::string &reason)>;

    // For a worker, which has one link. Null: there is no transport, `reason` says why.
    static std::unique_ptr<dxSimulatedNetwork> open(const dxSimulatedLink &link, const Open &open, std::string &reason);
    ~dxSimulatedNetwork() override;

    // For the server: solves by `solve`, and carries messages afterwards.
    dxRemoteServer::Solve carrying(dxRemoteServer::Solve solve);

    unsigned links() const override { return 1; }
    bool send(unsigned link, const void *message, std::size_t bytes) override;
    std::size_t waiting(unsigned &link) override;
    bool receive(void *message) override;
    // Passes on what has been sent when it is due, and closes the transport below.
    void close(bool isOrderly) override;

private:
    using Clock = std::chrono::steady_clock;
    using Lock = std::unique_lock<std::mutex>;
    struct Message {
        dxRemoteBytes bytes;
        Clock::time_point due;
    };
    // One direction: what is under way on it, the oldest first.
    struct Direction {
        std::deque<Message> messages;
        Clock::time_point busyUntil;
    };
    enum class State { Opening, Open, Closing, Closed };

    explicit dxSimulatedNetwork(const dxSimulatedLink &link) : m_link(link) {}

    void put(Direction &direction, dxRemoteBytes &&bytes, Clock::time_point sent) const;
    void lookFromWorker(Lock &lock);
    bool look(Lock &lock);
    bool passOn(Lock &lock);
    bool takeIn(Lock &lock);

    void run(const Open &open);
    void carry(Lock &lock);
    Clock::time_point nextLook();

    const dxSimulatedLink m_link;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake, m_changed;
    Direction m_toCoordinator, m_toWorker;
    State m_state = State::Opening;
    bool m_isOrderly = false, m_isLost = false;
    bool m_isForAllThreads = false;  // the transport below
    bool m_isLooking = false;        // somebody
    Clock::time_point m_workerLooked, m_sleepsUntil;  // the latter: the thread
    std::string m_reason;
    std::unique_ptr<dxRemoteTransport> m_below;
    dxPollPause m_pause;
    Clock::time_point m_lastLook;
    std::thread m_thread;
};
