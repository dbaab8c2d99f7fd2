#include "remote/coordinator/dxRemoteLink.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "remote/coordinator/dxRemoteProblem.h"

namespace {

// How long after the expected time a deadline is: predictions of single problems are rough, and systems suspend processes for
// moments.
constexpr double kLateFactor = 2, kLateNs = 2e6, kPatienceNs = 2e9;

constexpr double kFirstPauseNs = 10e6, kMaxPauseNs = 10e9;
constexpr double kGoneNs = 2e9;

// The largest latency: one of a worker that was suspended while it was measured would be too long, and deadlines follow from it.
constexpr double kMaxLatencyNs = 100e6, kMaxNsPerByte = 1000;

constexpr double kMinNsPerByte = 0.1;  // memory is not faster

constexpr double kLearning = 0.125;  // weight of a new value
constexpr double kFullCost = 400e3;  // ns; cheaper problems have a smaller weight, as most of their time is polling delay
constexpr double kForgetNs = 2e9;    // half-life of the estimate
constexpr double kMinSlowness = 0.05, kMaxSlowness = 50;

}  // namespace

bool dxRemoteLink::isGone(double now) const { return m_state == State::Open && m_isLate && now - m_lateSince > kGoneNs; }

bool dxRemoteLink::isFree(double now) const { return isUsable(now) && m_inFlight.size() < kMaxInFlight; }

void dxRemoteLink::setMeasured(double latencyNs, double nsPerByte) {
    m_latencyNs = std::min(latencyNs, kMaxLatencyNs);
    m_nsPerByte = std::clamp(nsPerByte, kMinNsPerByte, kMaxNsPerByte);
    if (m_state == State::Measured) m_state = State::Open;
}

// The estimate fades, since a worker that seems slow gets no problems that could show that it is fast: a disturbance is probably temporary.
double dxRemoteLink::slowness(double now) const {
    constexpr double kAll = 60;  // half-lives; more would underflow, which could raise a floating-point exception in the program
    return 1 + (m_slowness - 1) * std::exp2(-std::clamp((now - m_learntAt) / kForgetNs, 0.0, kAll));
}

// Returns the time from which the worker could solve them: problems that were sent later wait.
double dxRemoteLink::begin(const dxRemoteInFlight &problems) const {
    return std::max(problems.expected - problems.cost * m_slowness - problems.transferNs, problems.sent);
}

// Sets when each result should arrive, if the worker begins with the first problem at that time.
void dxRemoteLink::foresee(double from) {
    for (dxRemoteInFlight &problems : m_inFlight) {
        const double length = problems.cost * m_slowness + problems.transferNs;
        problems.expected = std::max(from, problems.sent) + length;
        const double patience = problems.isPatient ? kPatienceNs : kLateNs;
        problems.deadline = std::max(problems.deadline, std::max(from, problems.sent) + kLateFactor * length + patience);
        from = problems.expected;
    }
}

void dxRemoteLink::send(dxRemoteInFlight &&problems, std::size_t bytes, double now) {
    const double sleep = sleepNs(now);
    m_slowness = slowness(now);
    m_learntAt = now;
    problems.sent = now;
    problems.meetsSleep = sleep > 0;
    problems.transferNs = m_latencyNs + static_cast<double>(bytes) * m_nsPerByte + sleep;
    noteContact(now);
    m_inFlight.push_back(std::move(problems));
    foresee(m_inFlight.front().sent);
}

// The worker looks for messages at the end of its present pause.
void dxRemoteLink::noteContact(double now) {
    if (isAsleep(now)) m_looksBy = now + dxPollPause::longestNs(now - m_lastContact);
    m_lastContact = now;
}

// Returns how long a message may wait until the worker looks for it; 0: no longer than those with which the latency was measured.
double dxRemoteLink::sleepNs(double now) const {
    return isAsleep(now) ? dxPollPause::longestNs(now - m_lastContact) : std::max(m_looksBy - now, 0.0);
}

void dxRemoteLink::withdraw(std::uint64_t number) {
    for (dxRemoteInFlight &problems : m_inFlight)
        if (problems.number == number) problems.isWithdrawn = true;
}

bool dxRemoteLink::takeWithdrawal(std::uint64_t &number) {
    const auto isNews = [](const dxRemoteInFlight &one) { return one.isWithdrawn && !one.isWithdrawalSent; };
    const auto found = std::find_if(m_inFlight.begin(), m_inFlight.end(), isNews);
    if (found == m_inFlight.end()) return false;
    found->isWithdrawalSent = true;
    number = found->number;
    return true;
}

void dxRemoteLink::rescale(std::uint64_t batch, double factor) {
    if (m_inFlight.empty()) return;
    const double from = begin(m_inFlight.front());
    for (dxRemoteInFlight &problems : m_inFlight)
        if (dxRemoteBatchOf(problems.problems.front()) == batch) problems.cost *= factor;
    foresee(from);
}

bool dxRemoteLink::takeBack(std::uint64_t number, double now, dxRemoteInFlight &problems) {
    const auto found = std::find_if(m_inFlight.begin(), m_inFlight.end(), [number](const dxRemoteInFlight &one) { return one.number == number; });
    if (found == m_inFlight.end()) return false;
    noteContact(now);
    const bool wasFirst = found == m_inFlight.begin();
    problems = std::move(*found);
    m_inFlight.erase(found);
    if (!problems.isWithdrawn) ++m_answers;
    if (wasFirst && !problems.isWithdrawn && !problems.meetsSleep && !m_isLate && problems.cost > 0) {
        const double took = std::max(now - begin(problems) - problems.transferNs, 0.0);
        const double weight = kLearning * std::min(problems.cost / kFullCost, 1.0);
        m_learntAt = now;
        m_slowness += weight * (std::clamp(took / problems.cost, kMinSlowness, kMaxSlowness) - m_slowness);
    }
    if (wasFirst) foresee(now);
    if (m_isLate && m_inFlight.empty()) {
        m_isLate = false;
        m_pausedUntil = now + m_pauseNs;
    } else if (!m_isLate && ++m_onTime == kOnTimeToForget) {
        m_pauseNs = 0;
    }
    return true;
}

// Withdrawn problems have a deadline, too: a worker that does not answer is late, and gets no others until all its results have arrived.
double dxRemoteLink::deadline() const {
    if (m_isLate || m_state != State::Open) return std::numeric_limits<double>::infinity();
    return m_inFlight.empty() ? std::numeric_limits<double>::infinity() : m_inFlight.front().deadline;
}

bool dxRemoteLink::noticeLate(double now) {
    if (now < deadline()) return false;
    m_isLate = true;
    m_lateSince = now;
    m_onTime = 0;
    m_pauseNs = std::clamp(2 * m_pauseNs, kFirstPauseNs, kMaxPauseNs);
    return true;
}
