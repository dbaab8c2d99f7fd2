#include "frame/dxCostModel.h"

#include <algorithm>

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
// this part of it. (A try that loses n ns raises the average by kLearningRate n.)
constexpr double kTrying = 0.004;
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
    const unsigned workers = static_cast<unsigned>(std::min<double>(limit, useful));
    if (workers >= 2) {
        const double parallel = std::max(largest * scale(stepper), serial / workers) + price;
        if (parallel < kLeastGain * serial) return workers;
    }
    m_price.set(std::max(price - kTrying * kLearningRate * serial, kLeastPrice));
    return 1;
}

void dxCostModel::learnSerial(dxStepperKind stepper, double total, double ns) {
    if (total > 0) m_scale[index(stepper)].add(ns / total);
}

void dxCostModel::learnParallel(dxStepperKind stepper, double total, double largest, unsigned workers,
                                double busyNs, double wallNs) {
    if (total <= 0) return;
    m_scale[index(stepper)].add(busyNs / total);
    const double ideal = std::max(busyNs / workers, largest * scale(stepper));
    m_price.add(std::max(wallNs - ideal, kLeastPrice));
}
