// Predicts how long islands take and decides how many workers a step should use.
//
// An island's cost is a form whose shape follows from the algorithm and whose scale is learned:
//
//   dWorldStep       b·B + j·J + c·J³      B bodies, J joints; the cube is the LCP's factorisation
//   dWorldQuickStep  b·B + J·(j + r·I)     I iterations of the sweep over the rows
//
// in nanoseconds on a machine of scale 1. The scale of this machine, one number per stepper, and the
// price of sharing a step out (waking workers, waiting for the last of them) are running averages of what
// the steps themselves measured. Sharing out over w workers is predicted to take
//
//   max(largest block, total / w) + price
//
// and is chosen where that is clearly less than the total. Nothing depends on the world: a small world
// stays on the caller's thread because its total is below the price. Results never depend on the model,
// only speed does.
//
// Tried and dropped: a fixed least number of bodies (right for one machine and one stepper only); cost by
// rows instead of joints (asking every joint for its rows costs more than the better estimate brings).
//
// Threading: all functions may be called from any thread; the averages are relaxed atomics, a lost
// update only delays learning.
#pragma once

#include <atomic>

enum class dxStepperKind { World, Quick };

// A running average that is not spoilt by one odd value, such as that of a thread which the system took off
// its core for milliseconds: the first of several surprising values counts for little.
class dxRunningAverage {
public:
    explicit dxRunningAverage(double first) : m_mean(first) {}

    double mean() const { return m_mean.load(std::memory_order_relaxed); }
    void set(double mean) { m_mean.store(mean, std::memory_order_relaxed); }
    void add(double value);

private:
    std::atomic<double> m_mean;
    std::atomic<bool> m_surprised{false};
};

class dxCostModel {
public:
    // ns on a machine of scale 1.
    static double islandCost(dxStepperKind stepper, int iterations, unsigned bodies, unsigned joints);

    // The workers a step should use, 1: the caller alone. `total` and `largest`: costs of all islands
    // and of the largest. `limit`: the most workers there may be.
    unsigned chooseWorkers(dxStepperKind stepper, double total, double largest, unsigned limit);

    // A step on the caller alone took `ns` for islands of cost `total`.
    void learnSerial(dxStepperKind stepper, double total, double ns);

    // A step shared out over `workers` took `wallNs`; its workers were busy for `busyNs` in all.
    void learnParallel(dxStepperKind stepper, double total, double largest, unsigned workers, double busyNs,
                       double wallNs);

    double scale(dxStepperKind stepper) const { return m_scale[index(stepper)].mean(); }
    double price() const { return m_price.mean(); }  // ns

private:
    static int index(dxStepperKind stepper) { return static_cast<int>(stepper); }

    dxRunningAverage m_scale[2] = {dxRunningAverage(1), dxRunningAverage(1)};
    dxRunningAverage m_price{10e3};  // before the first measurement: two thread wake-ups
};
