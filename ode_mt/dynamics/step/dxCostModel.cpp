#include "dynamics/step/dxCostModel.h"

#include <algorithm>

#include "core/dxLog.h"
#include "threading/payoff/dxParallelPayoff.h"
#include "threading/process/dxProcess.h"

namespace {

// Measured with Debian's libode8 on one core of an AMD EPYC 9005 (stacks of ten boxes, humanoids of 17
// bodies); they fix the shape of the forms, the scale is learned.
constexpr double kBody = 250;             // ns
constexpr double kStepJoint = 900;        // ns
constexpr double kStepJointCubed = 4;     // ns
constexpr double kDirectJoint = 1e4;      // ns, in a wall of bricks
constexpr double kQuickJoint = 350;       // ns
constexpr double kFastQuickStepJoint = 250;    // ns
constexpr double kFastQuickStepIteration = 6;  // ns per contact
constexpr double kQuickIteration = 33;    // ns per joint of about three rows

// A moving average over about sixteen steps follows a change of load within a second of simulation.
constexpr double kWeight = 1.0 / 16;

// Without this margin prediction errors would make worlds slower.
constexpr double kMargin = 0.9;

// An overhead that was once measured too high would never be measured again, since steps are no longer
// parallel. So it fades with the time spent on the caller, slowly enough that probes lose at most
// this part of that time. (A probe whose steps lose n ns on average sets the overhead n ns above what would pay.)
constexpr double kLossLimit = 0.004;

// Each step that pays shortens the interval until a probe: a later disturbance is probably temporary. It is a
// part of the interval that keeps to the loss limit.
constexpr dxRetryLimits<double> kRetry{1.0 / 32, 1};
constexpr double kShortened = 1 / (1 + kWeight);

// A step that lost more than this many times its time on the caller was disturbed, and counts as if it had lost this.
constexpr double kOutlierFactor = 2;

constexpr unsigned kColdSteps = 2;  // of a probe
constexpr double kAbortFactor = 10;    // times its time on the caller: a cold step's overhead that ends a probe

// Steps whose time on the caller is at least this part of that of a probe's first step belong to the probe, too.
constexpr double kSimilarCost = 0.8;

constexpr double kMinOverhead = 2e3;  // ns

// A value beyond this many times the mean is an outlier, and is limited to this multiple unless the next one is an
// outlier, too.
constexpr double kOutlier = 4;

dxProcessObject<dxCostModel> costModel;

}  // namespace

dxCostModel &dxCostModel::instance() { return *costModel; }

void dxSteadyAverage::add(double value) {
    const double old = mean();
    const bool isOutlier = value > kOutlier * old;
    const bool again = m_hadOutlier.exchange(isOutlier, std::memory_order_relaxed);
    const double weighted = isOutlier && !again ? kOutlier * old : value;
    set(dxMovingAverage(old, weighted, kWeight));
}

double dxCostModel::islandCost(dxStepperKind stepper, int iterations, unsigned bodies, unsigned joints) {
    const double j = joints;
    const double exact = kStepJoint * j + kStepJointCubed * j * j * j;
    if (stepper == dxStepperKind::WorldExact) return kBody * bodies + exact;
    if (stepper == dxStepperKind::WorldFast) return kBody * bodies + std::min(exact, kDirectJoint * j);
    if (stepper == dxStepperKind::QuickFast) return kBody * bodies + j * (kFastQuickStepJoint + kFastQuickStepIteration * std::max(iterations, 0));
    return kBody * bodies + j * (kQuickJoint + kQuickIteration * std::max(iterations, 0));
}

unsigned dxCostModel::chooseWorkers(dxStepperKind stepper, double total, double largest, unsigned limit) {
    const double serial = total * scale(stepper);
    const double overhead = this->overhead();
    if (limit >= 2 && isProbed(serial)) return std::min(limit, m_probe.workers.load(std::memory_order_relaxed));
    // Waking a worker must not take longer than its work.
    const double useful = serial / std::max(overhead, kMinOverhead);
    const unsigned workers = static_cast<unsigned>(std::min<double>(limit, useful));
    const auto parallel = [&] { return std::max(largest * scale(stepper), serial / workers) + overhead; };
    if (workers < 2 || !dxPaysClearly(parallel(), serial, kMargin)) {
        fadeOverhead(serial);
        return 1;
    }
    if (m_hasFaded.exchange(false, std::memory_order_relaxed)) {
        beginProbe(serial, workers);
    } else {
        const double interval = m_retryInterval.load(std::memory_order_relaxed);
        m_retryInterval.store(kRetry.afterSuccess(interval, kShortened), std::memory_order_relaxed);
    }
    return workers;
}

bool dxCostModel::isProbed(double serial) const {
    return m_probe.stepsLeft.load(std::memory_order_relaxed) > 0 &&
           serial >= kSimilarCost * m_probe.serial.load(std::memory_order_relaxed);
}

void dxCostModel::beginProbe(double serial, unsigned workers) {
    m_probe.workers.store(workers, std::memory_order_relaxed);
    m_probe.serial.store(serial, std::memory_order_relaxed);
    m_probe.stepsLeft.store(kProbeSteps, std::memory_order_relaxed);
}

void dxCostModel::fadeOverhead(double serial) {
    const double part = kLossLimit / kProbeSteps / m_retryInterval.load(std::memory_order_relaxed);
    m_overhead.set(std::max(overhead() - part * serial, kMinOverhead));
    m_hasFaded.store(true, std::memory_order_relaxed);
}

void dxCostModel::learnScale(dxStepperKind stepper, double scale) {
    m_scale[index(stepper)].add(scale);
    m_lastScale[index(stepper)].store(scale, std::memory_order_relaxed);
}

void dxCostModel::learnSerial(dxStepperKind stepper, double total, double ns) {
    if (total > 0) learnScale(stepper, ns / total);
}

void dxCostModel::learnParallel(dxStepperKind stepper, double total, double largest, unsigned workers,
                                double busyNs, double wallNs) {
    if (total <= 0) return;
    learnScale(stepper, busyNs / total);
    const double ideal = std::max(busyNs / workers, largest * scale(stepper));
    const double overhead = std::max(wallNs - ideal, kMinOverhead);
    const double serial = total * scale(stepper);
    if (isProbed(serial)) {
        learnFromProbe(overhead, ideal, serial);
    } else {
        m_overhead.add(std::min(overhead, std::max(kOutlierFactor * serial, kMinOverhead)));
    }
}

// A probe ends early with a warm step that takes more than twice its time on the caller, or a cold one that takes
// ten times as long.
void dxCostModel::learnFromProbe(double overhead, double ideal, double serial) {
    const unsigned left = m_probe.stepsLeft.load(std::memory_order_relaxed);
    if (left == 0) return;  // another thread's step has ended it
    const unsigned steps = kProbeSteps - left + 1;
    m_probe.overheads[steps - 1].store(overhead, std::memory_order_relaxed);
    m_probe.stepsLeft.store(left - 1, std::memory_order_relaxed);
    if (left == 1 || overhead > (steps > kColdSteps ? 1 : kAbortFactor) * serial) endProbe(steps, ideal, serial);
}

// The overhead is that of the middle one of the warm steps, which a step that the system disturbed does not change.
// If it does not pay, it is at least what all steps lost, so that the next probe is far enough away.
void dxCostModel::endProbe(unsigned steps, double ideal, double serial) {
    m_probe.stepsLeft.store(0, std::memory_order_relaxed);
    double overheads[kProbeSteps], lost = 0;
    for (unsigned i = 0; i < steps; ++i) lost += overheads[i] = m_probe.overheads[i].load(std::memory_order_relaxed);
    const unsigned firstWarm = std::min(kColdSteps, steps - 1), middle = (firstWarm + steps) / 2;
    std::nth_element(overheads + firstWarm, overheads + middle, overheads + steps);
    const double median = overheads[middle];
    const bool pays = dxPaysClearly(ideal + median, serial, kMargin);
    dxLog(dxLogLevel::Debug, "cost model: a step of %.0f us on the caller costs %.0f us to share out, which %s",
          serial / 1e3, median / 1e3, pays ? "pays" : "does not pay");
    m_overhead.set(pays ? median : std::max(std::min(median, serial), lost / kProbeSteps));
    if (pays) return;
    const double interval = m_retryInterval.load(std::memory_order_relaxed);
    m_retryInterval.store(kRetry.afterFailure(interval), std::memory_order_relaxed);
}
