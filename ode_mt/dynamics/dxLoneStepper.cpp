#include "dynamics/dxLoneStepper.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace {

// Either the lone thread sees that there are several, or the newcomer sees the step in progress: both write
// first and read second, sequentially consistent.
std::atomic<const char *> g_onlyThread{nullptr};
std::atomic<bool> g_several{false};
std::atomic<bool> g_loneStep{false};

thread_local char t_identity;  // its address tells threads apart

bool isOnlyThread() {
    const char *only = nullptr;
    return g_onlyThread.compare_exchange_strong(only, &t_identity) || only == &t_identity;
}

void waitForLoneStep() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (g_loneStep.load() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
}

}  // namespace

dxLoneStepper::dxLoneStepper() : m_alone(false), m_outermost(false) {
    if (g_several.load()) return;
    if (!isOnlyThread()) {
        g_several.store(true);
        waitForLoneStep();
        return;
    }
    m_outermost = !g_loneStep.exchange(true);
    m_alone = !g_several.load();
}

dxLoneStepper::~dxLoneStepper() {
    if (m_outermost) g_loneStep.store(false);
}
