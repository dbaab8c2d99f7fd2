#include "threading/pool/dxParking.h"

#include <algorithm>

namespace {

constexpr std::uint32_t kOneParked = 1;
constexpr std::uint32_t kOneSearching = 1u << 16;

unsigned parkedIn(std::uint32_t counts) { return counts & 0xffff; }
unsigned searchingIn(std::uint32_t counts) { return counts >> 16; }

}  // namespace

void dxParking::reset() {
    m_counts.store(0);
    m_tokens.store(0);
    m_isWatched.store(false);
}

void dxParking::beginSearch() { m_counts.fetch_add(kOneSearching); }

void dxParking::endSearch() { m_counts.fetch_sub(kOneSearching); }

unsigned dxParking::searching() const { return searchingIn(m_counts.load()); }

unsigned dxParking::idle() const {
    const std::uint32_t now = m_counts.load();
    return searchingIn(now) + parkedIn(now);
}

void dxParking::wake(unsigned wanted) {
    std::uint32_t now = m_counts.load();
    unsigned woken;
    do {
        if (parkedIn(now) == 0 || searchingIn(now) >= wanted) return;
        woken = std::min(parkedIn(now), wanted - searchingIn(now));
    } while (!m_counts.compare_exchange_weak(now, now + woken * (kOneSearching - kOneParked)));
    dxPerturb(dxSchedulePoint::WakeWorkers);
    m_tokens.fetch_add(woken);
    dxFutexWake(m_tokens, woken);
}

void dxParking::wakeAll() { wake(0xffff); }

void dxParking::countAsParked() { m_counts.fetch_sub(kOneSearching - kOneParked); }

// If meanwhile a wake-up was decided for all that counted as parked, one of them is for this worker.
void dxParking::unpark() {
    dxPerturb(dxSchedulePoint::Unpark);
    std::uint32_t now = m_counts.load();
    while (parkedIn(now) > 0) {
        if (m_counts.compare_exchange_weak(now, now + kOneSearching - kOneParked)) return;
    }
    takeToken();
}

void dxParking::takeToken() {
    while (!tryToTakeToken()) dxFutexWait(m_tokens, 0);
}

bool dxParking::tryToTakeToken() {
    std::uint32_t available = m_tokens.load();
    dxPerturb(dxSchedulePoint::ClaimWakeUp);
    while (available > 0)
        if (m_tokens.compare_exchange_weak(available, available - 1)) return true;
    return false;
}
