#include "threading/pool/dxParking.h"

#include <algorithm>

namespace {

constexpr std::uint32_t oneParked = 1;
constexpr std::uint32_t oneSearching = 1u << 16;

unsigned parkedIn(std::uint32_t counts) { return counts & 0xffff; }
unsigned searchingIn(std::uint32_t counts) { return counts >> 16; }

}  // namespace

void dxParking::reset() {
    counts.store(0);
    tokens.store(0);
    watched.store(false);
}

void dxParking::beginSearch(unsigned workers) { counts.fetch_add(workers * oneSearching); }

void dxParking::endSearch(unsigned workers) { counts.fetch_sub(workers * oneSearching); }

unsigned dxParking::searching() const { return searchingIn(counts.load()); }

unsigned dxParking::idle() const {
    const std::uint32_t now = counts.load();
    return searchingIn(now) + parkedIn(now);
}

void dxParking::wake(unsigned wanted) {
    std::uint32_t now = counts.load();
    unsigned woken;
    do {
        if (parkedIn(now) == 0 || searchingIn(now) >= wanted) return;
        woken = std::min(parkedIn(now), wanted - searchingIn(now));
    } while (!counts.compare_exchange_weak(now, now + woken * (oneSearching - oneParked)));
    dxPerturb(dxSchedulePoint::WakeWorkers);
    tokens.fetch_add(woken);
    dxFutexWake(tokens, woken);
}

void dxParking::wakeAll() { wake(0xffff); }

void dxParking::countAsParked() { counts.fetch_sub(oneSearching - oneParked); }

// If everybody counted as parked has been promised a wake-up meanwhile, so has this worker.
void dxParking::unpark() {
    dxPerturb(dxSchedulePoint::Unpark);
    std::uint32_t now = counts.load();
    while (parkedIn(now) > 0) {
        if (counts.compare_exchange_weak(now, now + oneSearching - oneParked)) return;
    }
    takeToken();
}

void dxParking::takeToken() {
    while (!tryToTakeToken()) dxFutexWait(tokens, 0);
}

bool dxParking::tryToTakeToken() {
    std::uint32_t available = tokens.load();
    dxPerturb(dxSchedulePoint::ClaimWakeUp);
    while (available > 0)
        if (tokens.compare_exchange_weak(available, available - 1)) return true;
    return false;
}
