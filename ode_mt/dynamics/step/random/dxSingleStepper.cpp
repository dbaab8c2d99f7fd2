#include "dynamics/step/random/dxSingleStepper.h"

#include <atomic>
#include <chrono>

#include "core/dxGuards.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxSchedulePoints.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace {

thread_local char t_identity;  // its address identifies the thread

// Either the lone thread sees that there are several, or the newcomer sees the step in progress: both write
// first and read second, sequentially consistent.
class LoneThread final : private dxForkListener {
public:
    LoneThread() { listenToForks(); }

    std::atomic<const char *> only{nullptr};
    std::atomic<bool> several{false};
    std::atomic<bool> isStepping{false};
    std::atomic<bool> isInUserCode{false};  // of that step
    dxStackFrame frame;                     // of the outermost step; the lone thread's own

    bool isThis() {
        const char *known = nullptr;
        return only.compare_exchange_strong(known, &t_identity) || known == &t_identity;
    }

    // False: the step belongs to one in progress.
    bool beginStep(dxStackFrame current) {
        if (isStepping.load(std::memory_order_relaxed) && frame.called(current)) return false;
        frame = current;
        isInUserCode.store(dxTrapsFloatingPoint());  // whose handler may leave the step by siglongjmp
        isStepping.store(true);
        return true;
    }

    void awaitStep() const {
        using Clock = std::chrono::steady_clock;
        constexpr std::chrono::seconds kMaxUserTime{1};
        dxPerturb(dxSchedulePoint::AwaitSingleStepper);
        Clock::time_point inStep = Clock::now();
        while (isStepping.load()) {
            const Clock::time_point now = Clock::now();
            if (!isInUserCode.load())
                inStep = now;
            else if (now - inStep > kMaxUserTime)
                return;
            dxSleep(std::chrono::microseconds(20));
        }
    }

private:
    // The step in progress continues here if it is the forking thread's.
    void inForkedChild() override {
        if (only.load() != &t_identity) isStepping.store(false);
    }
};

dxProcessObject<LoneThread> lone;

}  // namespace

dxSingleStepper::dxSingleStepper() : m_alone(false), m_outermost(false) {
    LoneThread &thread = *lone;
    if (thread.several.load()) return;
    if (!thread.isThis()) {
        thread.several.store(true);
        thread.awaitStep();
        return;
    }
    m_outermost = thread.beginStep(dxStackFrame::ofCaller());
    m_alone = !thread.several.load();
}

dxSingleStepper::~dxSingleStepper() {
    if (m_outermost) lone->isStepping.store(false);
}

dxSingleStepper::UserCode::UserCode() : m_isNoted(lone->isStepping.load() && lone->only.load() == &t_identity) {
    if (m_isNoted) m_wasNoted = lone->isInUserCode.exchange(true);
}

dxSingleStepper::UserCode::~UserCode() {
    if (m_isNoted) lone->isInUserCode.store(m_wasNoted);
}
