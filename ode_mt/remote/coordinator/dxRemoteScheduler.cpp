#include "remote/coordinator/dxRemoteScheduler.h"

#include <limits>
#include <new>

#include "core/dxLog.h"
#include "remote/coordinator/dxRemoteSchedule.h"

dxRemoteCapacity dxRemoteScheduler::capacity() const {
    dxRemoteCapacity sum;
    if (!areThere()) return sum;
    const double time = now();
    for (const dxRemoteWorker &one : m_workers)
        if (one.link.isUsable(time)) sum.add(one.link, time);
    return sum;
}

dxRemoteCounts dxRemoteScheduler::counts() const {
    dxRemoteCounts counts = m_counts;
    if (!areThere()) return counts;
    const double time = now();
    for (const dxRemoteWorker &one : m_workers) {
        if (!one.isOpen()) continue;
        ++counts.open;
        counts.openLate += !one.link.isUsable(time);
    }
    return counts;
}

// --- workers ------------------------------------------------------------------------------------------------

void dxRemoteScheduler::begin(std::vector<dxRemoteWorker> &workers) {
    for (dxRemoteWorker &one : workers) one.since = now();
    m_workers.swap(workers);
    m_hasLost = false;
}

void dxRemoteScheduler::dropWorker(unsigned worker, const char *why, const char *detail) {
    dxRemoteWorker &one = m_workers[worker];
    if (one.isLost()) return;
    dxLog(dxLogLevel::Warning, "remote worker %u %s%s; it is left out", worker + 1, why, detail);
    one.restart.begin(now(), one.link.hasProved());
    one.link.lose();
    ++(one.isRefused ? m_counts.refused : m_counts.lost);
    m_hasLost = true;
    for (const dxRemoteInFlight &lost : one.link.inFlight()) reclaim(lost.problems, dxRemoteOutcome::Lost);
    noteAvailable();
    const double time = now();
    if (!any([time](const dxRemoteWorker &other) { return other.link.isUsable(time); })) reclaimQueue();
    m_news.notify();
}

void dxRemoteScheduler::dropUnreachable(unsigned worker, const char *why) {
    m_workers[worker].isUnreachable = true;
    dropWorker(worker, why);
}

void dxRemoteScheduler::dropAll(const char *why) {
    dxLog(dxLogLevel::Warning, "remote workers: %s; islands stay in this process", why);
    for (unsigned i = 0; i < m_workers.size(); ++i) dropWorker(i, "cannot be talked to");
    reclaimQueue();
}

void dxRemoteScheduler::noticeLate() {
    const double time = now();
    bool isAnyUsable = false;
    for (dxRemoteWorker &one : m_workers) {
        const bool isAwaited = m_waiting != 0 || !isSolving(one.link);
        if (isAwaited && one.link.noticeLate(time)) {
            ++m_counts.late;
            dxLog(dxLogLevel::Debug, "remote worker %zu is late", static_cast<std::size_t>(&one - m_workers.data()) + 1);
            for (const dxRemoteInFlight &late : one.link.inFlight()) reclaim(late.problems, dxRemoteOutcome::Late);
            m_news.notify();
        }
        isAnyUsable |= one.link.isUsable(time);
    }
    if (!isAnyUsable && !m_queue.empty()) reclaimQueue();
}

// Returns a problem of a step in progress.
bool dxRemoteScheduler::isSolving(const dxRemoteLink &link) const {
    return !link.inFlight().empty() && m_steps.count(dxRemoteBatchOf(link.inFlight().front().problems.front())) != 0;
}

void dxRemoteScheduler::warnOfMemory() {
    if (std::exchange(m_hasWarnedOfMemory, true)) return;
    dxLog(dxLogLevel::Warning, "remote workers: no memory for a message; its islands stay in this process");
}

// --- problems -----------------------------------------------------------------------------------------------

void dxRemoteScheduler::add(dxRemoteProblems &problems) {
    problems.number = m_nextStep++;
    for (unsigned i = 0; i < problems.all.size(); ++i) problems.all[i].number = dxRemoteNumber(problems.number, i);
    m_steps[problems.number] = &problems;
}

void dxRemoteScheduler::remove(const dxRemoteProblems &problems) {
    m_steps.erase(problems.number);
    m_queue.remove_if([&problems](const dxRemoteProblem *one) { return dxRemoteBatchOf(one->number) == problems.number; });
}

void dxRemoteScheduler::enqueue(dxRemoteProblem &problem, std::list<dxRemoteProblem *> &nodes) {
    nodes.front() = &problem;
    const auto isDearer = [](const dxRemoteProblem *a, const dxRemoteProblem *b) { return a->cost > b->cost; };
    m_queue.splice(std::upper_bound(m_queue.begin(), m_queue.end(), &problem, isDearer), nodes, nodes.begin());
}

dxRemoteProblem *dxRemoteScheduler::takeUnsent(const dxRemoteProblems &problems) {
    const auto isOfStep = [&problems](const dxRemoteProblem *one) { return dxRemoteBatchOf(one->number) == problems.number; };
    const auto found = std::find_if(m_queue.rbegin(), m_queue.rend(), isOfStep);
    if (found == m_queue.rend()) return nullptr;
    dxRemoteProblem *const problem = *found;
    m_queue.erase(std::next(found).base());
    return problem;
}

// Towards the end of a step messages become small, so that all workers end at the same time.
bool dxRemoteScheduler::takeMessage(dxRemoteSending &sending) {
    if (m_queue.empty()) return false;
    const double time = now();
    dxRemoteWorker *const freest = dxFindFreestLink(m_workers, time);
    if (freest == nullptr) return false;
    sending.worker = static_cast<unsigned>(freest - m_workers.data());
    double queued = 0;
    for (const dxRemoteProblem *problem : m_queue) queued += problem->cost;
    const double most = dxMaxMessageCost(queued, m_workers.size());
    dxRemoteInFlight sent{m_nextMessage++, {}, 0, 0, 0};
    std::size_t bytes = 0;
    auto end = m_queue.begin();
    try {
        do {
            const dxRemoteProblem &problem = **end;
            sent.problems.push_back(problem.number);
            sent.cost += problem.cost;
            sent.isPatient |= problem.isPatient;
            bytes += problem.bytes.size();
        } while (++end != m_queue.end() && sent.cost + (*end)->cost <= most);
        sending.number = sent.number;
        sending.problems = sent.problems;
        sending.bytes.reserve(sent.problems.size());
        freest->link.send(std::move(sent), bytes, time);
    } catch (const std::bad_alloc &) {
        warnOfMemory();
        reclaimQueue();
        sending.problems.clear();
        return true;
    }
    for (auto taken = m_queue.begin(); taken != end; taken = m_queue.erase(taken)) {
        dxRemoteProblem &problem = **taken;
        problem.state = dxRemoteProblem::State::Sent;
        problem.isSent = true;
        problem.worker = sending.worker;
        sending.bytes.push_back(std::move(problem.bytes));
        ++m_counts.sent;
    }
    return true;
}

void dxRemoteScheduler::takeMessageBack(const dxRemoteSending &sending) {
    warnOfMemory();
    dxRemoteInFlight unsent;
    dxRemoteLink &link = m_workers[sending.worker].link;
    link.withdraw(sending.number);  // it is no measure of its speed
    if (link.takeBack(sending.number, now(), unsent)) reclaim(unsent.problems, dxRemoteOutcome::NoResult);
    m_news.notify();
}

void dxRemoteScheduler::accept(unsigned worker, const dxRemoteBytes &results) {
    dxRemoteLink &link = m_workers[worker].link;
    const std::uint64_t number = dxReadHeader(results).number;
    dxRemoteItems all(results);
    std::size_t count = 0;
    while (all.next()) ++count;
    if (count == 0) link.withdraw(number);  // it is no measure of its speed
    dxRemoteInFlight expected;
    if (!link.takeBack(number, now(), expected)) return dropWorker(worker, "sent results of nothing");
    bool isSound = all.isAtEnd() && (count == expected.problems.size() || count == 0);
    dxRemoteItems items(results);
    for (std::size_t i = 0; i < count && isSound; ++i) {
        items.next();
        isSound = items.number() == expected.problems[i];
    }
    if (!isSound) {
        reclaim(expected.problems, dxRemoteOutcome::Lost);
        return dropWorker(worker, "sent results of other problems");
    }
    try {
        store(results);
    } catch (const std::bad_alloc &) {
        warnOfMemory();
        reclaim(expected.problems, dxRemoteOutcome::NoResult);
    }
    if (count == 0) reclaim(expected.problems, dxRemoteOutcome::NoResult);
    m_news.notify();
}

void dxRemoteScheduler::store(const dxRemoteBytes &results) {
    for (dxRemoteItems item(results); item.next();) {
        const auto found = m_steps.find(dxRemoteBatchOf(item.number()));
        if (found == m_steps.end()) continue;  // the step has ended
        const unsigned index = dxRemoteIndexOf(item.number());
        dxRemoteProblem &problem = found->second->all[index];
        if (problem.state != dxRemoteProblem::State::Sent && problem.state != dxRemoteProblem::State::Reclaimed) continue;  // is solved
        problem.bytes.assign(item.data(), item.data() + item.size());
        problem.state = dxRemoteProblem::State::Returned;
        found->second->returned.push_back(index);
    }
}

void dxRemoteScheduler::reclaim(dxRemoteProblem &problem, dxRemoteOutcome why) {
    if (problem.state != dxRemoteProblem::State::Queued && problem.state != dxRemoteProblem::State::Sent) return;
    problem.state = dxRemoteProblem::State::Reclaimed;
    problem.outcome = why;
    m_steps[dxRemoteBatchOf(problem.number)]->reclaimed.push_back(dxRemoteIndexOf(problem.number));
}

void dxRemoteScheduler::reclaim(const std::vector<std::uint64_t> &problems, dxRemoteOutcome why) {
    for (const std::uint64_t number : problems) {
        const auto found = m_steps.find(dxRemoteBatchOf(number));
        if (found != m_steps.end()) reclaim(found->second->all[dxRemoteIndexOf(number)], why);
    }
}

void dxRemoteScheduler::reclaimQueue() {
    for (dxRemoteProblem *problem : m_queue) reclaim(*problem, dxRemoteOutcome::Late);
    m_queue.clear();
    m_news.notify();
}

bool dxRemoteScheduler::withdrawLast(const dxRemoteProblems &problems) {
    dxRemoteLink *link = nullptr;
    const dxRemoteInFlight *last = nullptr;
    for (dxRemoteWorker &one : m_workers) {
        for (const dxRemoteInFlight &sent : one.link.inFlight()) {
            if (sent.isWithdrawn || dxRemoteBatchOf(sent.problems.front()) != problems.number) continue;
            if (last != nullptr && sent.expected <= last->expected) continue;
            last = &sent;
            link = &one.link;
        }
    }
    if (last == nullptr || !dxIsSoonerHere(last->cost, last->expected, now())) return false;
    m_hasWithdrawals = true;
    link->withdraw(last->number);
    reclaim(last->problems, dxRemoteOutcome::Sooner);
    return true;
}

void dxRemoteScheduler::rescale(dxRemoteProblems &problems, double factor) {
    for (dxRemoteProblem &problem : problems.all) problem.cost *= factor;
    for (dxRemoteWorker &one : m_workers) one.link.rescale(problems.number, factor);
}

double dxRemoteScheduler::nextDeadline() const {
    double first = std::numeric_limits<double>::infinity();
    for (const dxRemoteWorker &one : m_workers) first = std::min(first, one.link.deadline());
    return first;
}
