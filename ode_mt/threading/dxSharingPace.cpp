#include "threading/dxSharingPace.h"

#include <algorithm>
#include <utility>

namespace {

// Below, waking a worker may take longer than the whole call.
constexpr double kWorthSharing = 30e3;  // ns

constexpr int kFirstCalls = 2;               // alone, before anything is tried
constexpr int kTrial = 3;                    // calls
constexpr int kShortestWait = 48, kLongestWait = 768;

// To be taken, the other way has to be better by this; times are noisy.
constexpr double kClearly = 0.97;

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
    if (++way.fresh > 1 || way.ns == 0) way.ns = way.fresh == 2 ? ns : faded(way, ns);
    if (shared != m_isSharing) return;  // too small to be shared
    if (m_isTrial)
        judge();
    else if (++m_calls >= m_wait && way.fresh >= kFirstCalls && (m_isSharing || m_alone.ns >= kWorthSharing)) {
        m_isTrial = true;
        m_isSharing = !m_isSharing;
    }
}

// At the end of a trial.
void dxSharingPace::judge() {
    const Way &tried = m_isSharing ? m_shared : m_alone, &usual = m_isSharing ? m_alone : m_shared;
    if (tried.fresh < kTrial) return;
    m_isTrial = false;
    m_calls = 0;
    if (tried.ns < kClearly * usual.ns) {
        m_wait = kShortestWait;
    } else {
        m_isSharing = !m_isSharing;
        m_wait = std::clamp(2 * m_wait, kShortestWait, kLongestWait);
    }
}
