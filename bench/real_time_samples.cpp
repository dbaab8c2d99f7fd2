#include "real_time_samples.h"

namespace bench {

std::vector<double> realTimeSamples(const EngineResult &engine, double period) {
    std::vector<double> samples;
    double simulated = 0, measured = 0;
    for (const Batch &batch : engine.batches) {
        simulated += batch.frames * engine.ready.stepSize;
        measured += secondsOf(batch.seconds, Part::Frame);
        if (measured < period) continue;
        samples.push_back(simulated / measured);
        simulated = measured = 0;
    }
    return samples;
}

}  // namespace bench
