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
// and is chosen where that is clearly less than the total. A price that keeps steps on the caller is not
// measured any more; it fades, and is then tried in a few steps in a row: the first of them find the workers
// asleep and pay more than those that follow, so one step alone would tell too high a price. A trial in vain
// makes the next one later; where sharing has paid before, the first trials come soon. Nothing depends on the world: a small world
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
    static constexpr unsigned kTrialSteps = 8;

    // Steps that are shared out to measure the price anew, whatever it was.
    struct Trial {
        std::atomic<unsigned> stepsLeft{0}, workers{0};
        std::atomic<double> serial{0};           // ns: what the first of them would have taken on the caller
        std::atomic<double> prices[kTrialSteps] = {};
    };

    static int index(dxStepperKind stepper) { return static_cast<int>(stepper); }

    bool isTried(double serial) const;
    void beginTrial(double serial, unsigned workers);
    void learnTrial(double price, double ideal, double serial);
    void endTrial(unsigned steps, double ideal, double serial);
    void setEagerness(double value);
    void fadePrice(double serial);

    dxRunningAverage m_scale[2] = {dxRunningAverage(1), dxRunningAverage(1)};
    dxRunningAverage m_price{10e3};  // before the first measurement: two thread wake-ups
    std::atomic<double> m_eagerness{1};  // how many times faster the price fades than at least
    std::atomic<bool> m_faded{false};  // not measured since: the next step that is shared out begins a trial
    Trial m_trial;
};
