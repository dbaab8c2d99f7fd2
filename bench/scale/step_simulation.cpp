#include "scale/step_simulation.h"

#include "remote/islands/dxRemoteShare.h"
#include "dynamics/step/dxCostModel.h"
#include "remote/transport/dxPollPause.h"
#include "remote/coordinator/dxRemoteLink.h"
#include "remote/coordinator/dxRemoteProblem.h"
#include "remote/coordinator/dxRemoteSchedule.h"
#include "remote/worker/dxSimulatedNetwork.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace scale {

namespace {

// Of a message, besides its bytes, at each end: to make it, hand it to MPI or take it from there.
constexpr double kMessageNs = 1e3;
constexpr double kFrameBytes = 32, kItemBytes = 16;  // headers

// While home's thread has a long island, another one looks for messages after this time.
constexpr double kBesideHomeNs = 1e6;

// Of what is done at home for an island that goes out: to make its problem; the rest applies results.
constexpr double kMakePart = 0.7;

// Of that, for each island however small: locks; at most half of it. The rest goes by bytes.
constexpr double kIslandNs = 8e3;

double costOf(const Problem &problem) {
    return dxCostModel::islandCost(dxStepperKind::WorldExact, 0, static_cast<unsigned>(problem.bodies), static_cast<unsigned>(problem.joints));
}

}  // namespace

class StepSimulation::Play {
public:
    Play(const MeasuredWorld &measured, const Cluster &cluster);
    double run(const Step &step);

    Counts counts;

private:
    enum class State { Expected, Queued, Sent, Returned, AtHome, Done };
    struct Island {
        double solveNs, homeNs, makeNs, finishNs;  // homeNs: all of it, if it stays
        double bytes, resultBytes;
        double costNs;  // what the library thinks that all of it takes at home
        State state = State::Expected;
    };
    struct Message {
        std::uint64_t number = 0;
        std::vector<unsigned> islands;
        double bytes = 0, solveNs = 0, resultBytes = 0;
    };
    struct Worker {
        dxRemoteLink link;
        std::deque<Message> received;
        bool isBusy = false;
        double problemNs = 0;  // of those that it solves
        double idleSince = 0;
        double outBusyUntil = 0, inBusyUntil = 0;  // of the wires, if they are its own
    };
    using Action = std::function<void()>;
    struct Event {
        double time;
        std::uint64_t order;
        Action action;
        bool operator<(const Event &other) const { return std::pair(time, order) > std::pair(other.time, other.order); }
    };

    void at(double time, Action action) { m_events.push({std::max(time, m_now), m_order++, std::move(action)}); }
    void makeIslands(const Step &step);
    double shareOf() const;
    bool isOver() const;
    double costOf(unsigned island) const { return m_islands[island].costNs * kRemoteSolverPart; }
    double lookNs(double idleNs) const;
    // By the worker, which carries all messages a second time.
    bool isSimulated() const { return m_cluster.cores > 0 && m_cluster.network.isSlowed(); }

    // --- home's thread ----------------------------------------------------------------------------------------
    void goOn(bool hasNew = false);  // a problem in the queue
    bool takeUnsent(unsigned &island);
    bool withdrawLast();
    void noticeLate();
    void takeHome(const std::vector<std::uint64_t> &problems);
    void solveAtHome(unsigned island);
    void finish(double ns) {
        m_busyNs += ns;
        at(m_now + ns, [this] { goOn(); });
    }
    void wakeHome();

    // --- messages at home: by its thread between two islands, or by another one if these are long -------------------
    struct Arrived {
        double ns;  // to receive it
        Action handle;
    };
    double look();
    double lookForAll();
    double sendNext();
    void lookBesideHome();
    double carryNs(const Worker &worker) const;
    void transmit(bool isOut, unsigned worker, double bytes, Action then);
    void arriveHome(double ns, Action handle);
    void handleResults(unsigned worker, const Message &message, bool isWithdrawn);

    // --- a worker ------------------------------------------------------------------------------------------------
    void arriveAtWorker(unsigned worker, Message message);
    void solveNext(unsigned worker);
    void withdraw(unsigned worker, std::uint64_t number);

    const MeasuredWorld m_measured;
    const Cluster m_cluster;
    double m_copyNsPerByte;  // at one end
    double m_restPerByte, m_awayPerByte, m_awayPerIsland, m_homeSolver;
    double m_costScale = 1;  // without steps at home the library has nothing to learn from

    double m_now = 0;
    std::uint64_t m_order = 0, m_step = 0, m_nextMessage = 1;
    std::priority_queue<Event> m_events;
    std::vector<Worker> m_workers;
    double m_outBusyUntil = 0, m_inBusyUntil = 0;

    std::vector<Island> m_islands;
    std::vector<unsigned> m_away, m_staying;  // in the order in which they are made, stepped
    std::vector<unsigned> m_queue;  // the most expensive first
    std::vector<unsigned> m_returned, m_atHome;
    double m_end = 0;
    double m_busyNs = 0;  // of all processors
    std::size_t m_made = 0, m_stepped = 0, m_left = 0;
    bool m_isWaiting = false, m_isDone = false;
    double m_lookedAt = -kRemoteBetweenLooksNs;
    double m_lastNews = 0;  // when home's thread last had something to do
    double m_deadline = 0;  // of what it waits for
    std::deque<Arrived> m_arrived;
    std::vector<std::pair<unsigned, std::uint64_t>> m_withdrawals;
};

StepSimulation::Play::Play(const MeasuredWorld &measured, const Cluster &cluster)
    : m_measured(measured), m_cluster(cluster), m_workers(cluster.workers) {
    std::vector<double> bytes, costs, islandCounts;
    for (const Step &step : measured.steps) {
        islandCounts.push_back(static_cast<double>(step.size()));
        bytes.push_back(0);
        costs.push_back(0);
        for (const Problem &problem : step) {
            bytes.back() += problem.bytes;
            costs.back() += scale::costOf(problem);
        }
    }
    if (!cluster.sendsAll) m_costScale = measured.homeStepNs / std::max(typical(costs), 1.0);
    const double perStep = std::max(typical(bytes), 1.0), solve = std::max(measured.solveNs(), 1.0);
    // What a step takes at home besides its solver. Where the worker was slower than home is, at least a part.
    constexpr double kMinRest = 0.05;
    const double rest = std::max(measured.homeStepNs - solve, kMinRest * measured.homeStepNs);
    m_restPerByte = rest / perStep;
    const double islands = std::max(typical(islandCounts), 1.0);
    m_awayPerIsland = std::min(kIslandNs, measured.awayStepNs / islands / 2);
    m_awayPerByte = (measured.awayStepNs - islands * m_awayPerIsland) / perStep;
    m_homeSolver = (measured.homeStepNs - rest) / solve;
    m_copyNsPerByte = measured.nsPerByte / 2;
    for (Worker &worker : m_workers) {
        worker.link.welcome();
        worker.link.setMeasured(measured.latencyNs + 2 * cluster.network.delayNs, measured.nsPerByte + cluster.network.nsPerByte());
    }
}

void StepSimulation::Play::makeIslands(const Step &step) {
    m_islands.clear();
    for (const Problem &problem : step) {
        const double away = m_awayPerIsland + m_awayPerByte * problem.bytes;
        m_islands.push_back({problem.solveNs, m_homeSolver * problem.solveNs + m_restPerByte * problem.bytes, kMakePart * away,
                             (1 - kMakePart) * away, problem.bytes, problem.resultBytes, m_costScale * scale::costOf(problem)});
    }
}

double StepSimulation::Play::shareOf() const {
    if (m_cluster.workers == 0 || m_islands.empty()) return 0;
    if (m_cluster.sendsAll) return 1;
    dxRemoteWork work;
    for (const Island &island : m_islands) {
        work.totalNs += island.costNs;
        work.largestNs = std::max(work.largestNs, island.costNs);
    }
    for (const Problem &problem : m_measured.steps.front()) {
        work.bodies += problem.bodies;
        work.joints += problem.joints;
    }
    work.islands = static_cast<double>(m_islands.size());
    dxRemoteCapacity capacity;
    for (const Worker &worker : m_workers)
        if (worker.link.isUsable(m_now)) capacity.add(worker.link, m_now);
    return std::min(kRemoteReserve * dxPredictRemoteShare(work, 1, capacity), 1.0);
}

double StepSimulation::Play::run(const Step &step) {
    makeIslands(step);
    double total = 0, cost = 0;
    for (const Island &island : m_islands) {
        total += island.homeNs;
        cost += island.costNs;
    }
    const double share = shareOf();
    if (!(share > 0)) {
        m_now += total + m_measured.restNs();
        return total;
    }
    std::vector<unsigned> order(m_islands.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [this](unsigned a, unsigned b) { return m_islands[a].costNs > m_islands[b].costNs; });
    m_away.clear();
    m_staying.clear();
    double left = share * cost;
    for (const unsigned island : order) {
        (m_cluster.sendsAll || left > 0 ? m_away : m_staying).push_back(island);
        left -= m_islands[island].costNs;
    }
    ++m_step;
    m_queue.clear();
    m_returned.clear();
    m_atHome.clear();
    m_made = m_stepped = 0;
    m_left = m_away.size();
    m_isWaiting = m_isDone = false;
    m_busyNs = 0;
    const double begin = m_now;
    goOn();
    while (!isOver()) {
        if (m_isWaiting && (m_events.empty() || m_events.top().time > m_deadline)) {
            m_now = m_deadline;
            wakeHome();
            continue;
        }
        if (m_events.empty()) break;
        const Event event = m_events.top();
        m_events.pop();
        m_now = event.time;
        event.action();
    }
    m_events = {};
    if (m_cluster.cores > 0) m_end = std::max(m_end, begin + m_busyNs / m_cluster.cores);
    m_now = std::max(m_now, m_end + m_measured.restNs());
    return m_end - begin;
}

// Also what comes too late has come.
bool StepSimulation::Play::isOver() const {
    return m_isDone && std::all_of(m_workers.begin(), m_workers.end(), [](const Worker &one) { return one.link.inFlight().empty(); });
}

// --- home's thread --------------------------------------------------------------------------------------------------

// The next thing that home's thread does, as dxIslandParallelStep::runBlocks and dxRemoteBatch::next have it.
void StepSimulation::Play::goOn(bool hasNew) {
    if (m_isDone) return;
    m_lastNews = m_now;
    const bool isUrgent = hasNew && dxIsAnyIdle(m_workers, m_now);
    if (isUrgent || (m_made > 0 && m_now - m_lookedAt >= kRemoteBetweenLooksNs)) {
        if (const double ns = lookForAll(); ns > 0) return finish(ns);
    }
    if (m_made < m_away.size()) {
        const unsigned island = m_away[m_made++];
        m_busyNs += m_islands[island].makeNs;
        at(m_now + m_islands[island].makeNs, [this, island] {
            m_islands[island].state = State::Queued;
            m_queue.insert(std::upper_bound(m_queue.begin(), m_queue.end(), island, [this](unsigned a, unsigned b) { return costOf(a) > costOf(b); }),
                           island);
            goOn(true);
        });
        return;
    }
    if (m_stepped < m_staying.size()) return finish(m_islands[m_staying[m_stepped++]].homeNs);
    for (;;) {
        if (!m_returned.empty()) {
            const unsigned island = m_returned.back();
            m_returned.pop_back();
            if (m_islands[island].state != State::Returned) continue;
            m_islands[island].state = State::Done;
            --m_left;
            return finish(m_islands[island].finishNs);
        }
        unsigned island = 0;
        if (!m_atHome.empty()) {
            island = m_atHome.back();
            m_atHome.pop_back();
            if (m_islands[island].state == State::AtHome) return solveAtHome(island);
            continue;
        }
        if (m_left == 0) {
            m_isDone = true;
            m_end = m_now;
            return;
        }
        if (!m_cluster.sendsAll && takeUnsent(island)) return solveAtHome(island);
        noticeLate();
        if (m_atHome.empty() && (m_cluster.sendsAll || !withdrawLast())) break;
    }
    if (const double ns = lookForAll(); ns > 0) return finish(ns);
    m_isWaiting = true;
    m_deadline = std::numeric_limits<double>::infinity();
    for (const Worker &worker : m_workers) m_deadline = std::min(m_deadline, worker.link.deadline());
}

void StepSimulation::Play::solveAtHome(unsigned island) {
    Island &one = m_islands[island];
    one.state = State::Done;
    --m_left;
    finish(m_homeSolver * one.solveNs + one.finishNs);
}

bool StepSimulation::Play::takeUnsent(unsigned &island) {
    if (m_queue.empty()) return false;
    island = m_queue.back();
    m_queue.pop_back();
    return true;
}

bool StepSimulation::Play::withdrawLast() {
    unsigned worker = 0;
    const dxRemoteInFlight *last = nullptr;
    for (unsigned i = 0; i < m_workers.size(); ++i) {
        for (const dxRemoteInFlight &sent : m_workers[i].link.inFlight()) {
            if (sent.isWithdrawn || (last != nullptr && sent.expected <= last->expected)) continue;
            last = &sent;
            worker = i;
        }
    }
    if (last == nullptr || !dxIsSoonerHere(last->cost, last->expected, m_now)) return false;
    m_withdrawals.emplace_back(worker, last->number);
    const std::vector<std::uint64_t> problems = last->problems;
    m_workers[worker].link.withdraw(last->number);
    takeHome(problems);
    return true;
}

void StepSimulation::Play::takeHome(const std::vector<std::uint64_t> &problems) {
    for (const std::uint64_t number : problems) {
        const unsigned island = dxRemoteIndexOf(number);
        if (dxRemoteBatchOf(number) != m_step || m_islands[island].state != State::Sent) continue;
        ++counts.takenBack;
        m_islands[island].state = State::AtHome;
        m_atHome.push_back(island);
    }
}

void StepSimulation::Play::noticeLate() {
    bool isAnyUsable = false;
    for (Worker &worker : m_workers) {
        if (worker.link.noticeLate(m_now))
            for (const dxRemoteInFlight &late : worker.link.inFlight()) takeHome(late.problems);
        isAnyUsable |= worker.link.isUsable(m_now);
    }
    if (isAnyUsable) return;
    for (const unsigned island : std::exchange(m_queue, {})) {
        m_islands[island].state = State::AtHome;
        m_atHome.push_back(island);
    }
}

void StepSimulation::Play::wakeHome() {
    if (std::exchange(m_isWaiting, false)) at(m_now + lookNs(m_now - m_lastNews), [this] { goOn(); });
}

// --- messages at home -----------------------------------------------------------------------------------------------

// Half of the pause in which a message finds one that has had nothing to do for so long.
double StepSimulation::Play::lookNs(double idleNs) const {
    const double waited = idleNs - std::chrono::duration<double, std::nano>(dxPollPause::kAtOnce).count();
    return waited <= 0 ? 0 : (dxPollPause::pauseNs(waited, dxPollPause::longestNs(waited)) + m_measured.sleepNs) / 2;
}

// One message. Returns how long that takes; 0: there is none to send or to receive.
double StepSimulation::Play::look() {
    if (!m_withdrawals.empty()) {
        const auto [worker, number] = m_withdrawals.back();
        m_withdrawals.pop_back();
        at(m_now + kMessageNs, [this, worker = worker, number = number] {
            transmit(true, worker, kFrameBytes, [this, worker, number] { withdraw(worker, number); });
        });
        return kMessageNs;
    }
    if (const double ns = sendNext(); ns > 0) return ns;
    if (m_arrived.empty()) return 0;
    const Arrived one = std::move(m_arrived.front());
    m_arrived.pop_front();
    one.handle();
    return one.ns;
}

// Messages are sent when they are made, one after the other.
double StepSimulation::Play::lookForAll() {
    m_lookedAt = m_now;
    double all = 0;
    const double begin = m_now;
    for (double ns; (ns = look()) > 0; m_now = begin + all) all += ns;
    m_now = begin;
    return all;
}

void StepSimulation::Play::lookBesideHome() {
    if (m_arrived.empty()) return;
    if (const double ns = look(); ns > 0) at(m_now + ns, [this] { lookBesideHome(); });
    while (sendNext() > 0) {}
}

double StepSimulation::Play::sendNext() {
    if (m_queue.empty()) return 0;
    Worker *const best = dxFindFreestLink(m_workers, m_now);
    if (best == nullptr) return 0;
    double queued = 0;
    for (const unsigned island : m_queue) queued += costOf(island);
    const double most = dxMaxMessageCost(queued, m_workers.size());

    Message message;
    message.number = m_nextMessage++;
    message.bytes = message.resultBytes = kFrameBytes;
    dxRemoteInFlight sent{message.number, {}, 0, 0, 0};
    std::size_t bytes = 0, taken = 0;
    do {
        const unsigned island = m_queue[taken++];
        Island &one = m_islands[island];
        one.state = State::Sent;
        sent.problems.push_back(dxRemoteNumber(m_step, island));
        sent.cost += costOf(island);
        sent.isPatient |= m_cluster.sendsAll;
        bytes += static_cast<std::size_t>(one.bytes);
        message.islands.push_back(island);
        message.bytes += one.bytes + kItemBytes;
        message.resultBytes += one.resultBytes + kItemBytes;
        message.solveNs += one.solveNs;
    } while (taken < m_queue.size() && sent.cost + costOf(m_queue[taken]) <= most);
    m_queue.erase(m_queue.begin(), m_queue.begin() + static_cast<std::ptrdiff_t>(taken));
    best->link.send(std::move(sent), bytes, m_now);
    ++counts.messages;
    counts.sent += message.islands.size();
    counts.bytes += message.bytes + message.resultBytes;

    const unsigned worker = static_cast<unsigned>(best - m_workers.data());
    const double ns = kMessageNs + message.bytes * m_copyNsPerByte;
    at(m_now + ns, [this, worker, message] {
        transmit(true, worker, message.bytes, [this, worker, message] { arriveAtWorker(worker, message); });
    });
    return ns;
}

void StepSimulation::Play::transmit(bool isOut, unsigned worker, double bytes, Action then) {
    Worker &own = m_workers[worker];
    double &busyUntil = m_cluster.sharesWire ? (isOut ? m_outBusyUntil : m_inBusyUntil) : (isOut ? own.outBusyUntil : own.inBusyUntil);
    busyUntil = std::max(busyUntil, m_now) + bytes * m_cluster.network.nsPerByte();
    const double arrives = busyUntil + m_cluster.network.delayNs;
    if (isOut || !isSimulated()) return at(arrives, std::move(then));
    at(arrives, [this, &own, then = std::move(then)] { at(m_now + carryNs(own), then); });
}

// A simulated network passes on what is due between two problems, and, if these take long, when its thread looks.
double StepSimulation::Play::carryNs(const Worker &worker) const {
    constexpr double kBesideWorkerNs = std::chrono::duration<double, std::nano>(dxSimulatedNetwork::kBesideWorker).count();
    return worker.isBusy ? std::min(worker.problemNs, kBesideWorkerNs) / 2 : lookNs(m_now - worker.idleSince);
}

void StepSimulation::Play::arriveHome(double ns, Action handle) {
    m_arrived.push_back({ns, std::move(handle)});
    if (m_isWaiting) return wakeHome();
    at(m_now + kBesideHomeNs, [this] { lookBesideHome(); });
}

void StepSimulation::Play::handleResults(unsigned worker, const Message &message, bool isWithdrawn) {
    dxRemoteInFlight expected;
    m_workers[worker].link.takeBack(message.number, m_now, expected);
    if (isWithdrawn) return takeHome(expected.problems);
    for (const std::uint64_t number : expected.problems) {
        if (dxRemoteBatchOf(number) != m_step || m_isDone) continue;
        Island &island = m_islands[dxRemoteIndexOf(number)];
        if (island.state != State::Sent && island.state != State::AtHome) continue;  // home was faster
        island.state = State::Returned;
        m_returned.push_back(dxRemoteIndexOf(number));
    }
}

// --- a worker -------------------------------------------------------------------------------------------------------

void StepSimulation::Play::arriveAtWorker(unsigned worker, Message message) {
    Worker &own = m_workers[worker];
    own.received.push_back(std::move(message));
    if (own.isBusy) return;
    own.isBusy = true;
    at(m_now + lookNs(m_now - own.idleSince), [this, worker] { solveNext(worker); });
}

void StepSimulation::Play::solveNext(unsigned worker) {
    Worker &own = m_workers[worker];
    if (own.received.empty()) {
        own.isBusy = false;
        own.idleSince = m_now;
        return;
    }
    const Message message = std::move(own.received.front());
    own.received.pop_front();
    const double carriedNs = 2 * kMessageNs + (message.bytes + message.resultBytes) * m_copyNsPerByte;
    const double took = (isSimulated() ? 2 : 1) * carriedNs + message.solveNs;
    m_busyNs += took;
    own.problemNs = message.solveNs / static_cast<double>(message.islands.size());
    at(m_now + took, [this, worker, message] {
        transmit(false, worker, message.resultBytes, [this, worker, message] {
            arriveHome(kMessageNs + message.resultBytes * m_copyNsPerByte, [this, worker, message] { handleResults(worker, message, false); });
        });
        solveNext(worker);
    });
}

// What it has not begun to solve it gives back, in a message without results.
void StepSimulation::Play::withdraw(unsigned worker, std::uint64_t number) {
    std::deque<Message> &received = m_workers[worker].received;
    const auto found = std::find_if(received.begin(), received.end(), [number](const Message &one) { return one.number == number; });
    if (found == received.end()) return;
    const Message message = std::move(*found);
    received.erase(found);
    transmit(false, worker, kFrameBytes, [this, worker, message] {
        arriveHome(kMessageNs, [this, worker, message] { handleResults(worker, message, true); });
    });
}

// --------------------------------------------------------------------------------------------------------------------

StepSimulation::StepSimulation(const MeasuredWorld &measured, const Cluster &cluster) : m_play(std::make_unique<Play>(measured, cluster)) {}
StepSimulation::~StepSimulation() = default;
double StepSimulation::run(const Step &step) { return m_play->run(step); }
StepSimulation::Counts StepSimulation::counts() const { return m_play->counts; }

double predictFrame(const MeasuredWorld &measured, const Cluster &cluster) {
    if (measured.steps.empty()) return measured.homeFrameNs;
    StepSimulation simulation(measured, cluster);
    // The first steps teach links how fast their workers are.
    constexpr std::size_t kLearning = 20;
    for (std::size_t i = 0; i < kLearning; ++i) simulation.run(measured.steps[i % measured.steps.size()]);
    std::vector<double> steps;
    for (const Step &step : measured.steps) steps.push_back(simulation.run(step));
    const double step = typical(steps);
    return measured.restNs() + (cluster.sendsAll ? step : std::min(step, measured.homeStepNs));
}

}  // namespace scale
