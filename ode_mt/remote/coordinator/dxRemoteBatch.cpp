#include "remote/coordinator/dxRemoteBatch.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "remote/coordinator/dxRemoteSchedule.h"

namespace {

constexpr double kPatienceNs = 3e9;  // a step that waits for workers takes problems that were not sent when nothing has happened for this time

class CountedWait {
public:
    explicit CountedWait(unsigned &count) : m_count(count) { ++m_count; }
    ~CountedWait() { --m_count; }
    CountedWait(const CountedWait &) = delete;
    CountedWait &operator=(const CountedWait &) = delete;

private:
    unsigned &m_count;
};

}  // namespace

dxRemoteBatch::dxRemoteBatch(dxRemoteWorkers &workers, unsigned count, bool mayReclaim)
    : m_workers(workers), m_scheduler(workers.m_scheduler), m_mayReclaim(mayReclaim), m_left(count) {
    m_problems.all.resize(count);
    m_problems.returned.reserve(count);
    m_problems.reclaimed.reserve(2 * std::size_t(count));  // once when its worker is late or lost, and again if what then came back was no result
    for (dxRemoteProblem &problem : m_problems.all) m_nodes.push_back(&problem);
    const dxRemoteLock lock(workers.m_mutex);
    m_forks = workers.m_forks;
    m_scheduler.add(m_problems);
}

dxRemoteBatch::~dxRemoteBatch() {
    const dxRemoteLock lock(m_workers.m_mutex);
    m_scheduler.remove(m_problems);
}

void dxRemoteBatch::submit(unsigned index, dxRemoteBytes &&bytes, double cost) {
    const bool isAnyIdle = queue(index, std::move(bytes), cost);
    m_workers.poll(isAnyIdle);
}

// Returns whether a worker has nothing to do.
bool dxRemoteBatch::queue(unsigned index, dxRemoteBytes &&bytes, double cost) {
    const dxRemoteLock lock(m_workers.m_mutex);
    dxRemoteProblem &problem = m_problems.all[index];
    problem.bytes = std::move(bytes);
    problem.cost = m_costRatio * cost;
    problem.isPatient = !m_mayReclaim;
    problem.state = State::Queued;
    if (!m_workers.areThere() || m_workers.m_isClosing) {
        m_scheduler.reclaim(problem, dxRemoteOutcome::Lost);
        return false;
    }
    m_scheduler.enqueue(problem, m_nodes);
    m_workers.notify();
    return dxIsAnyIdle(m_scheduler.workers(), m_scheduler.now());
}

dxRemoteBytes dxRemoteBatch::takeSpare() {
    const dxRemoteLock lock(m_workers.m_mutex);
    return m_scheduler.takeSpare();
}

void dxRemoteBatch::keep(unsigned index) {
    const dxRemoteLock lock(m_workers.m_mutex);
    m_problems.all[index].state = State::Reclaimed;
    m_problems.reclaimed.push_back(index);
    m_scheduler.news().notify();
}

void dxRemoteBatch::drop(unsigned index) {
    const dxRemoteLock lock(m_workers.m_mutex);
    m_problems.all[index].state = State::Done;
    --m_left;
    m_scheduler.news().notify();
}

void dxRemoteBatch::reject(unsigned index) {
    const dxRemoteLock lock(m_workers.m_mutex);
    dxRemoteProblem &problem = m_problems.all[index];
    m_scheduler.dropWorker(problem.worker, "sent a result that is none");
    ++m_left;
    problem.state = State::Reclaimed;
    problem.outcome = dxRemoteOutcome::Lost;
    m_problems.reclaimed.push_back(index);
    count(dxRemoteOutcome::Solved, -1);
}

void dxRemoteBatch::noteGivenBack() {
    const dxRemoteLock lock(m_workers.m_mutex);
    count(dxRemoteOutcome::Solved, -1);
    count(dxRemoteOutcome::NoResult);
}

// Costs are predicted. In a scene that settles, problems may take many times as long from one step to the next, but those of one step are alike.
void dxRemoteBatch::noteLocal(double cost, double ns) {
    constexpr double kChange = 1.1, kMax = 1e4;
    if (!(cost > 0)) return;
    const dxRemoteLock lock(m_workers.m_mutex);
    m_localCost += cost;
    m_localNs += ns;
    const double factor = std::clamp(m_localNs / m_localCost, 1 / kMax, kMax) / m_costRatio;
    if (factor < kChange && factor > 1 / kChange) return;
    m_costRatio *= factor;
    m_scheduler.rescale(m_problems, factor);
}

dxRemoteOutcomes dxRemoteBatch::outcomes() const {
    const dxRemoteLock lock(m_workers.m_mutex);
    return m_problems.outcomes;
}

void dxRemoteBatch::count(dxRemoteOutcome outcome, int change) {
    m_problems.outcomes[outcome] += static_cast<std::uint64_t>(change);
    m_scheduler.counters().outcomes[outcome] += static_cast<std::uint64_t>(change);
}

// A problem that has meanwhile been answered twice is in both lists.
bool dxRemoteBatch::takeReady(State state, unsigned &index, dxRemoteBytes *result) {
    std::vector<unsigned> &list = state == State::Returned ? m_problems.returned : m_problems.reclaimed;
    while (!list.empty()) {
        index = list.back();
        list.pop_back();
        dxRemoteProblem &problem = m_problems.all[index];
        if (problem.state != state) continue;
        problem.state = State::Done;
        if (problem.isSent) count(state == State::Returned ? dxRemoteOutcome::Solved : problem.outcome);
        if (result != nullptr) *result = std::move(problem.bytes);
        --m_left;
        return true;
    }
    return false;
}

bool dxRemoteBatch::takeUnsent(unsigned &index) {
    dxRemoteProblem *const problem = m_scheduler.takeUnsent(m_problems);
    if (problem == nullptr) return false;
    problem->state = State::Done;
    index = dxRemoteIndexOf(problem->number);
    --m_left;
    return true;
}

// Called in a child of fork(), where there are no workers.
void dxRemoteBatch::reclaimAll() {
    m_forks = m_workers.m_forks;
    for (dxRemoteProblem &problem : m_problems.all) m_scheduler.reclaim(problem, dxRemoteOutcome::Lost);
}

dxRemoteBatch::Next dxRemoteBatch::next(unsigned &index, dxRemoteBytes &result) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    dxRemoteLock lock(m_workers.m_mutex);
    const double begin = m_scheduler.now();
    dxPollPause pause;
    for (;;) {
        if (m_forks != m_workers.m_forks) reclaimAll();
        if (takeReady(State::Returned, index, &result)) return Next::Result;
        if (takeReady(State::Reclaimed, index, nullptr)) return Next::Reclaimed;
        if (m_left == 0) {
            m_scheduler.news().notify();  // others that wait for the last one
            return Next::None;
        }
        const double time = m_scheduler.now();
        const bool hurries = m_mayReclaim || time - begin > kPatienceNs;
        if (hurries && takeUnsent(index)) return Next::Reclaimed;
        const CountedWait wait(m_scheduler.waiting());
        m_scheduler.noticeLate();
        if (!m_problems.reclaimed.empty()) continue;
        if (m_mayReclaim && m_scheduler.withdrawLast(m_problems)) {
            m_workers.notify();
            continue;
        }
        const double deadline = std::min(m_scheduler.nextDeadline(), hurries ? kNever : begin + 1.01 * kPatienceNs);
        m_workers.waitForNews(lock, pause, deadline - time);
        m_scheduler.counters().waitedNs += m_scheduler.now() - time;
    }
}
