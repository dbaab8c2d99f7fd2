#include "threading/dxSharingPace.h"

#include <algorithm>
#include <utility>

#include "trace/dxLog.h"

namespace {

// Below, waking a worker may take longer than the whole call.
constexpr double kWorthSharing = 30e3;  // ns

constexpr int kFirstCalls = 2;               // alone, before anything is tried
constexpr int kTrial = 3;                    // calls
constexpr int kShortestWait = 48, kLongestWait = 768;

// In use, a way is compared anew if so many calls in a row were slower by this than after the last trial, each of them: one
// that was held up by something else says nothing.
constexpr double kSlower = 1.1;
constexpr int kSlowCalls = 5;

// To be taken, the other way has to be better by this; times are noisy.
constexpr double kClearly = 0.97;

// Of the time that is worked alone, what may be lost by trying to share.
constexpr double kTrialPart = 1.0 / 32;

// Calls worked alone whose time sharing may owe when it is tried again, and before it is given up; and whose time it may have saved
// up: more is not remembered.
constexpr double kDebtToTry = 2, kDebtInUse = 16, kMostSaved = 256;

// More of anything that is counted is not told apart.
constexpr int kMany = 1 << 20;

void countUp(int &count) { count = std::min(count + 1, kMany); }

// Of a measured time in the mean.
constexpr double kShare = 0.25;

}  // namespace

bool dxSharingPace::shallShare() const {
    return m_isSharing && m_alone.ns >= kWorthSharing;
}

double dxSharingPace::faded(const Way &way, double ns) {
    return way.ns == 0 ? ns : way.ns + kShare * (ns - way.ns);
}

void dxSharingPace::remember(bool shared, double ns) {
    Way &way = shared ? m_shared : m_alone, &other = shared ? m_alone : m_shared;
    other.fresh = 0;
    // The first call after a change of ways is not typical of the way.
    countUp(way.fresh);
    if (way.fresh > 1 || way.ns == 0) way.ns = way.fresh == 2 ? ns : faded(way, ns);
    account(shared, ns);
    if (shared != m_isSharing) return;  // too small to be shared
    if (m_isTrial) {
        judge();
        return;
    }
    countUp(m_calls);
    m_slowCalls = ns > kSlower * m_judgedNs ? std::min(m_slowCalls + 1, kMany) : 0;
    if (isTimeForTrial(way)) {
        m_isTrial = true;
        m_isSharing = !m_isSharing;
    }
}

bool dxSharingPace::isTimeForTrial(const Way &way) const {
    if (way.fresh < kFirstCalls || (!m_isSharing && m_alone.ns < kWorthSharing)) return false;
    if (m_isSharing && isTooDear()) return true;
    return (m_calls >= m_wait || isEarly()) && (m_isSharing || isPaidBack());
}

bool dxSharingPace::isEarly() const { return m_calls < m_wait && m_calls >= m_earlyWait && m_slowCalls >= kSlowCalls; }

bool dxSharingPace::isPaidBack() const { return -m_savedNs <= kDebtToTry * m_alone.ns; }
bool dxSharingPace::isTooDear() const { return -m_savedNs > kDebtInUse * m_alone.ns; }

void dxSharingPace::account(bool shared, double ns) {
    if (shared) m_savedNs = std::min(m_savedNs + m_alone.ns - ns, kMostSaved * m_alone.ns);
    else if (m_savedNs < 0) m_savedNs = std::min(m_savedNs + kTrialPart * ns, 0.0);
}

// At the end of a trial.
void dxSharingPace::judge() {
    const Way &tried = m_isSharing ? m_shared : m_alone, &usual = m_isSharing ? m_alone : m_shared;
    const bool isBrokenOff = m_isSharing && isTooDear();
    if (tried.fresh < kTrial && !isBrokenOff) return;
    const bool isTaken = !isBrokenOff && tried.ns < kClearly * usual.ns;
    if (isTaken) {
        m_wait = kShortestWait;
        m_earlyWait = kShortestEarlyWait;
    } else {
        m_isSharing = !m_isSharing;
        if (isEarly())
            m_earlyWait = std::min(2 * m_earlyWait, kLongestWait);
        else
            m_wait = std::clamp(2 * m_wait, kShortestWait, kLongestWait);
    }
    dxLog(dxLogLevel::debug, "a call of %.0f us takes %.0f us when the way in use is exchanged: %s from now on",
          usual.ns / 1e3, tried.ns / 1e3, m_isSharing ? "shared" : "alone");
    m_judgedNs = isTaken ? tried.ns : usual.ns;
    if (m_isSharing) m_savedNs = std::max(m_savedNs, 0.0);  // it pays
    m_isTrial = false;
    m_calls = m_slowCalls = 0;
}
