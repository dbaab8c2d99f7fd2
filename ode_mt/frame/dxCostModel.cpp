#include "frame/dxCostModel.h"

#include <algorithm>

#include "trace/dxLog.h"

namespace {

// Measured with Debian's libode8 on one core of an AMD EPYC 9005 (stacks of ten boxes, humanoids of 17
// bodies); they fix the shape of the forms, the scale is learned.
constexpr double kBody = 250;             // ns
constexpr double kStepJoint = 900;        // ns
constexpr double kStepJointCubed = 4;     // ns
constexpr double kQuickJoint = 350;       // ns
constexpr double kQuickIteration = 33;    // ns per joint of about three rows

// A running average over about sixteen steps follows a change of load within a second of simulation.
constexpr double kLearningRate = 1.0 / 16;

// Sharing out must promise this much, or prediction errors would make worlds slower.
constexpr double kLeastGain = 0.9;

// A price that was once measured too high would never be measured again, since nothing is shared out any
// more: it fades with the time spent on the caller, so slowly that what is lost by trying again is at most
// this part of it. (A trial whose steps lose n ns on average sets the price n ns above what would pay.)
// After steps that paid, it fades faster: what disturbed them has probably passed. Each trial in vain halves that.
constexpr double kTrying = 0.004;
constexpr double kMostEager = 32;

// A step that lost more than this many times its time on the caller was disturbed, and counts for no more.
constexpr double kDisturbed = 2;

constexpr unsigned kColdSteps = 2;  // of a trial: workers have to be woken, and find their caches cold
constexpr double kHopeless = 10;    // times its time on the caller: a cold step's price that ends a trial

// Steps whose time on the caller is this part of that of the first of a trial belong to it too.
constexpr double kAlike = 0.8;

constexpr double kLeastPrice = 2e3;  // ns

// No worker is woken for less work than this many prices.
constexpr double kWorthWaking = 1.0;

// A value beyond this many times the mean is a surprise, and counts for this much if it comes alone.
constexpr double kSurprise = 4;

}  // namespace

void dxRunningAverage::add(double value) {
    const double old = mean();
    const bool surprising = value > kSurprise * old;
    const bool again = m_surprised.exchange(surprising, std::memory_order_relaxed);
    const double believed = surprising && !again ? kSurprise * old : value;
    set(old + kLearningRate * (believed - old));
}

double dxCostModel::islandCost(dxStepperKind stepper, int iterations, unsigned bodies, unsigned joints) {
    const double j = joints;
    if (stepper == dxStepperKind::World) return kBody * bodies + kStepJoint * j + kStepJointCubed * j * j * j;
    return kBody * bodies + j * (kQuickJoint + kQuickIteration * std::max(iterations, 0));
}

unsigned dxCostModel::chooseWorkers(dxStepperKind stepper, double total, double largest, unsigned limit) {
    const double serial = total * scale(stepper);
    const double price = this->price();
    const double useful = serial / std::max(price * kWorthWaking, kLeastPrice);
    if (limit >= 2 && isTried(serial)) return std::min(limit, m_trial.workers.load(std::memory_order_relaxed));
    const unsigned workers = static_cast<unsigned>(std::min<double>(limit, useful));
    if (workers >= 2) {
        const double parallel = std::max(largest * scale(stepper), serial / workers) + price;
        if (parallel < kLeastGain * serial) {
            if (m_faded.exchange(false, std::memory_order_relaxed)) {
                beginTrial(serial, workers);
            } else {
                setEagerness(m_eagerness.load(std::memory_order_relaxed) * (1 + kLearningRate));
            }
            return workers;
        }
    }
    fadePrice(serial);
    return 1;
}

bool dxCostModel::isTried(double serial) const {
    return m_trial.stepsLeft.load(std::memory_order_relaxed) > 0 &&
           serial >= kAlike * m_trial.serial.load(std::memory_order_relaxed);
}

void dxCostModel::beginTrial(double serial, unsigned workers) {
    m_trial.workers.store(workers, std::memory_order_relaxed);
    m_trial.serial.store(serial, std::memory_order_relaxed);
    m_trial.stepsLeft.store(kTrialSteps, std::memory_order_relaxed);
}

void dxCostModel::setEagerness(double value) {
    m_eagerness.store(std::clamp(value, 1.0, kMostEager), std::memory_order_relaxed);
}

void dxCostModel::fadePrice(double serial) {
    const double part = kTrying / kTrialSteps * m_eagerness.load(std::memory_order_relaxed);
    m_price.set(std::max(price() - part * serial, kLeastPrice));
    m_faded.store(true, std::memory_order_relaxed);
}

void dxCostModel::learnSerial(dxStepperKind stepper, double total, double ns) {
    if (total > 0) m_scale[index(stepper)].add(ns / total);
}

void dxCostModel::learnParallel(dxStepperKind stepper, double total, double largest, unsigned workers,
                                double busyNs, double wallNs) {
    if (total <= 0) return;
    m_scale[index(stepper)].add(busyNs / total);
    const double ideal = std::max(busyNs / workers, largest * scale(stepper));
    const double price = std::max(wallNs - ideal, kLeastPrice);
    const double serial = total * scale(stepper);
    if (isTried(serial)) {
        learnTrial(price, ideal, serial);
    } else {
        m_price.add(std::min(price, std::max(kDisturbed * serial, kLeastPrice)));
    }
}

// A trial ends early with a warm step that takes more than twice its time on the caller, or a cold one that takes
// ten times as long.
void dxCostModel::learnTrial(double price, double ideal, double serial) {
    const unsigned left = m_trial.stepsLeft.load(std::memory_order_relaxed);
    if (left == 0) return;  // another thread's step has ended it
    const unsigned steps = kTrialSteps - left + 1;
    m_trial.prices[steps - 1].store(price, std::memory_order_relaxed);
    m_trial.stepsLeft.store(left - 1, std::memory_order_relaxed);
    if (left == 1 || price > (steps > kColdSteps ? 1 : kHopeless) * serial) endTrial(steps, ideal, serial);
}

// The price is that of the middle one of the warm steps, which a step that the system disturbed does not change.
// If it does not pay, it is at least what all steps lost, so that the next trial is far enough away.
void dxCostModel::endTrial(unsigned steps, double ideal, double serial) {
    m_trial.stepsLeft.store(0, std::memory_order_relaxed);
    double prices[kTrialSteps], lost = 0;
    for (unsigned i = 0; i < steps; ++i) lost += prices[i] = m_trial.prices[i].load(std::memory_order_relaxed);
    const unsigned firstWarm = std::min(kColdSteps, steps - 1), middle = (firstWarm + steps) / 2;
    std::nth_element(prices + firstWarm, prices + middle, prices + steps);
    const bool pays = ideal + prices[middle] < kLeastGain * serial;
    dxLog(dxLogLevel::debug, "cost model: a step of %.0f us on the caller costs %.0f us to share out, which %s",
          serial / 1e3, prices[middle] / 1e3, pays ? "pays" : "does not pay");
    m_price.set(pays ? prices[middle] : std::max(std::min(prices[middle], serial), lost / kTrialSteps));
    if (!pays) setEagerness(m_eagerness.load(std::memory_order_relaxed) / 2);
}
