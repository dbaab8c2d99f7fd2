// Predicts how long islands take and decides how many workers a step should use.
//
// An island's cost is a form whose shape follows from the algorithm and whose scale is learned:
//
//   dWorldStep       b·B + j·J + c·J³      B bodies, J joints; the cube is the LCP's factorisation
//   dWorldQuickStep  b·B + J·(j + r·I)     I iterations of the sweep over the rows
//   fast dWorldStep   b·B + d·J             about as many factorisations for any island
//   fast QuickStep   b·B + J·(j + r·I)     as dWorldQuickStep, with numbers of its own
//
// in nanoseconds on a machine of scale 1. The scale of this machine, one number per stepper, and the overhead of
// a parallel step are moving averages of what the steps themselves measured (dxParallelPayoff.h has the words). A parallel
// step on w workers is predicted to take
//
//   max(largest block, total / w) + overhead
//
// and is chosen where that is clearly less than the total. While the overhead estimate keeps steps on the caller, nothing
// measures it. So it fades until a parallel step seems to pay, and a probe then measures it. The speed at which it fades is
// the retry interval. Nothing depends on the world: a small world stays on the caller's thread because its total is below
// the overhead. Results never depend on the model, only speed does.
//
// Tried and dropped: a fixed minimum number of bodies (right for one machine and one stepper only); cost by
// rows instead of joints (asking every joint for its rows costs more than the better estimate gains).
//
// Threading: any thread. The averages are relaxed atomics; a lost update only delays learning.
#pragma once

#include <algorithm>
#include <atomic>

// dWorldStep and dWorldQuickStep, each with the solver "exact" and with "fast".
enum class dxStepperKind { WorldExact, QuickExact, WorldFast, QuickFast };
constexpr unsigned kStepperKinds = 4;

inline bool dxIsQuick(dxStepperKind kind) { return kind == dxStepperKind::QuickExact || kind == dxStepperKind::QuickFast; }

// A moving average that one outlier hardly changes, such as that of a thread that lost its core for milliseconds: the first of several surprising
// values has a small weight.
class dxSteadyAverage {
public:
    explicit dxSteadyAverage(double first) : m_mean(first) {}

    double mean() const { return m_mean.load(std::memory_order_relaxed); }
    void set(double mean) { m_mean.store(mean, std::memory_order_relaxed); }
    void add(double value);

private:
    std::atomic<double> m_mean;
    std::atomic<bool> m_hadOutlier{false};
};

class dxCostModel {
public:
    // Returns that of the process, since it measures the machine.
    static dxCostModel &instance();

    // Returns the cost of an island. Units: ns on a machine of scale 1.
    static double islandCost(dxStepperKind stepper, int iterations, unsigned bodies, unsigned joints);

    // Returns the number of workers that a step should use; 1: the caller alone. `total` and `largest`: costs of all islands
    // and of the largest. `limit`: the largest number allowed.
    unsigned chooseWorkers(dxStepperKind stepper, double total, double largest, unsigned limit);

    // Records that a step on the caller alone took `ns` for islands of cost `total`.
    void learnSerial(dxStepperKind stepper, double total, double ns);

    // Records that a step on several workers took `wallNs`, and that they were busy for `busyNs` in total.
    void learnParallel(dxStepperKind stepper, double total, double largest, unsigned workers, double busyNs,
                       double wallNs);

    double scale(dxStepperKind stepper) const { return m_scale[index(stepper)].mean(); }
    // The same, or that of the last step, if it was larger: where others have to be given time, and what settles may take four times as long
    // from one step to the next.
    double cautiousScale(dxStepperKind stepper) const {
        return std::max(scale(stepper), m_lastScale[index(stepper)].load(std::memory_order_relaxed));
    }
    double overhead() const { return m_overhead.mean(); }  // ns

private:
    static constexpr unsigned kProbeSteps = 8;

    // Steps that are shared out to measure the overhead anew, whatever it was.
    struct Probe {
        std::atomic<unsigned> stepsLeft{0}, workers{0};
        std::atomic<double> serial{0};           // ns: what the first of them would have taken on the caller
        std::atomic<double> overheads[kProbeSteps] = {};
    };

    static int index(dxStepperKind stepper) { return static_cast<int>(stepper); }

    void learnScale(dxStepperKind stepper, double scale);
    bool isProbed(double serial) const;
    void beginProbe(double serial, unsigned workers);
    void learnFromProbe(double overhead, double ideal, double serial);
    void endProbe(unsigned steps, double ideal, double serial);
    void fadeOverhead(double serial);

    dxSteadyAverage m_scale[kStepperKinds] = {dxSteadyAverage(1), dxSteadyAverage(1), dxSteadyAverage(1), dxSteadyAverage(1)};
    std::atomic<double> m_lastScale[kStepperKinds] = {};
    dxSteadyAverage m_overhead{10e3};        // before the first measurement: two thread wake-ups
    std::atomic<double> m_retryInterval{1};  // part of the longest
    std::atomic<bool> m_hasFaded{false};     // not measured since: the next step that is shared out begins a probe
    Probe m_probe;
};
