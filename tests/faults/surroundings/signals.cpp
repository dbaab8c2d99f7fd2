#include <sys/time.h>

#include <atomic>
#include <csignal>

#include "surroundings.h"

namespace faults {

namespace {

std::atomic<long> signalsCaught{0};

void onAlarm(int) { signalsCaught.fetch_add(1, std::memory_order_relaxed); }

}  // namespace

std::uint64_t underSignals() {
    struct sigaction action {};
    action.sa_handler = onAlarm;  // without SA_RESTART
    sigaction(SIGALRM, &action, nullptr);
    const itimerval often{{0, 200}, {0, 200}}, never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    std::uint64_t hash = playFrames();
    for (int i = 0; i < 9; ++i)
        if (playFrames() != hash) hash = 0;
    setitimer(ITIMER_REAL, &never, nullptr);
    return signalsCaught.load() > 10 ? hash : 0;
}

}  // namespace faults
