#include "threading/payoff/dxSharingPolicy.h"

#include <algorithm>

#include "core/dxLog.h"
#include "threading/payoff/dxParallelPayoff.h"

namespace {

// Below, waking a worker may take longer than the whole call.
constexpr double kMinShared = 30e3;  // ns

// Two readings of a clock take up to 0.1 us, more than 1 % of a call below this. One timed call in sixteen is enough to notice soon that a scene has
// grown.
constexpr double kMinTimed = 8e3;  // ns
constexpr int kUntimedCalls = 15;

constexpr int kMinCallsInRow = 2;  // alone, before the first probe
constexpr double kHopeless = 1.5;  // a call alone that takes this many times as long as shared ones ends its probe: the caller is never cold
constexpr dxRetryLimits<int> kRetry{48, 768};  // calls

// The way in use is compared anew if each of kSlowCalls calls in a row was slower by this factor than after the last probe: a single slow call may
// have been delayed by something else.
constexpr double kSlower = 1.1;
constexpr int kSlowCalls = 5;

// Times are noisy.
constexpr double kMargin = 0.97;

// The part of the time of calls alone that probes may cost.
constexpr double kLossLimit = 1.0 / 32;

// Debts, in times of a call alone: up to which a probe may begin, and beyond which sharing ends; and savings, beyond which no more are remembered.
constexpr double kMaxDebtToProbe = 2, kMaxDebtInUse = 16, kMaxSaved = 256;

// Counters stop here.
constexpr int kMany = 1 << 20;

void countUp(int &count) { count = std::min(count + 1, kMany); }

// The weight of the newest time in the average.
constexpr double kWeight = 0.25;

}  // namespace

bool dxSharingPolicy::shouldShare(double work) const { return m_isSharing && m_alone.ns * work >= kMinShared; }

bool dxSharingPolicy::shouldTimeAlone() {
    if (m_untimedCalls == 0) return true;
    --m_untimedCalls;
    return false;
}

// The first calls after a change of ways are cold, the next one begins the average anew.
void dxSharingPolicy::average(Way &way, double ns) {
    countUp(way.callsInRow);
    if (way.callsInRow <= way.cold && way.ns != 0) return;
    const bool isFirst = way.callsInRow == way.cold + 1 || way.ns == 0;
    way.ns = isFirst ? ns : dxMovingAverage(way.ns, ns, kWeight);
}

void dxSharingPolicy::record(bool shared, double callNs, double work) {
    m_work = work;
    const double ns = callNs / work;
    Way &way = shared ? m_shared : m_alone, &other = shared ? m_alone : m_shared;
    other.callsInRow = 0;
    average(way, ns);
    m_untimedCalls = m_alone.callsInRow >= kMinCallsInRow && m_alone.ns * work < kMinTimed ? kUntimedCalls : 0;
    account(shared, callNs);
    if (shared != m_isSharing) return;  // too small to be shared
    if (m_isProbe) {
        judgeProbe(ns);
        return;
    }
    countUp(m_calls);
    if (m_doubtedNs > 0 && way.callsInRow >= way.probe) {
        if (hasGrownSince(way)) {
            m_isSharing = !m_isSharing;
            beginUse(m_doubtedNs);
            return;
        }
        m_doubtedNs = 0;
    }
    m_slowCalls = ns > kSlower * m_judgedNs ? std::min(m_slowCalls + 1, kMany) : 0;
    if (isTimeForProbe(way)) {
        m_isProbe = true;
        m_isSharing = !m_isSharing;
    }
}

bool dxSharingPolicy::isTimeForProbe(const Way &way) const {
    if (way.callsInRow < kMinCallsInRow || (!m_isSharing && m_alone.ns * m_work < kMinShared)) return false;
    if (m_isSharing && isDebtTooHigh()) return true;
    return (m_calls >= m_retryInterval || isEarly()) && (m_isSharing || isPaidBack());
}

bool dxSharingPolicy::isEarly() const {
    return m_calls < m_retryInterval && m_calls >= m_earlyRetryInterval && m_slowCalls >= kSlowCalls;
}

bool dxSharingPolicy::isPaidBack() const { return -m_savedNs <= kMaxDebtToProbe * m_alone.ns * m_work; }
bool dxSharingPolicy::isDebtTooHigh() const { return -m_savedNs > kMaxDebtInUse * m_alone.ns * m_work; }

void dxSharingPolicy::account(bool shared, double ns) {
    const double aloneNs = m_alone.ns * m_work;
    if (shared) m_savedNs = std::min(m_savedNs + aloneNs - ns, kMaxSaved * aloneNs);
    else if (m_savedNs < 0) m_savedNs = std::min(m_savedNs + kLossLimit * ns, 0.0);
}

// `ns`: of its last call.
void dxSharingPolicy::judgeProbe(double ns) {
    const Way &probed = m_isSharing ? m_shared : m_alone, &usual = m_isSharing ? m_alone : m_shared;
    const bool isHopeless = !m_isSharing && ns > kHopeless * usual.ns, isBrokenOff = isHopeless || (m_isSharing && isDebtTooHigh());
    if (isHopeless) m_alone.ns = ns;
    if (probed.callsInRow < probed.probe && !isBrokenOff) return;
    const bool pays = !isBrokenOff && dxPaysClearly(probed.ns, usual.ns, kMargin);
    dxLog(dxLogLevel::Debug, "a call of %.0f us takes %.0f us when the way in use is exchanged: %s from now on",
          usual.ns * m_work / 1e3, probed.ns * m_work / 1e3, m_isSharing == pays ? "shared" : "alone");
    if (pays) return beginUse(probed.ns);
    m_isSharing = !m_isSharing;
    if (isEarly())
        m_earlyRetryInterval = dxRetryLimits<int>{kMinEarlyRetry, kRetry.longest}.afterFailure(m_earlyRetryInterval);
    else
        m_retryInterval = kRetry.afterFailure(m_retryInterval);
    m_doubtedNs = probed.ns;
    endProbe(usual.ns);
}

// The way that is in use from now on has turned out to pay.
void dxSharingPolicy::beginUse(double ns) {
    m_retryInterval = kRetry.shortest;
    m_earlyRetryInterval = kMinEarlyRetry;
    if (m_isSharing) m_savedNs = std::max(m_savedNs, 0.0);
    m_doubtedNs = 0;
    endProbe(ns);
}

void dxSharingPolicy::endProbe(double ns) {
    m_judgedNs = ns;
    m_isProbe = false;
    m_calls = m_slowCalls = 0;
}

// The calls after a probe that did not pay: they would have been the faster ones.
bool dxSharingPolicy::hasGrownSince(const Way &way) const {
    const bool isSlower = way.ns > kSlower * m_judgedNs;
    return isSlower && dxPaysClearly(m_doubtedNs, way.ns, kMargin) && (m_isSharing || isPaidBack());
}

dxProcessSharingPolicy::Answer dxProcessSharingPolicy::ask(double work) {
    const std::unique_lock<std::mutex> hold(m_mutex, std::try_to_lock);
    if (!hold) return Answer::InUse;
    return m_policy.shouldShare(work) ? Answer::Shared : Answer::Alone;
}

bool dxProcessSharingPolicy::record(bool shared, double ns, double work) {
    const std::unique_lock<std::mutex> hold(m_mutex, std::try_to_lock);
    if (!hold) return false;
    m_policy.record(shared, ns, work);
    return m_policy.shouldShare(work);
}
