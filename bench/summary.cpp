#include "summary.h"

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

namespace {

// `references`: of the engines before, one of each release.
StateCheck stateCheck(const WorldResult &result, const EngineResult &engine, std::vector<const EngineResult *> &references) {
    if (engine.batches.empty()) return StateCheck::Unknown;
    if (!engine.engine.isReproducible()) return StateCheck::NotReproducible;
    if (!engine.engine.hasUpstreamsBits()) return StateCheck::OwnBits;
    if (engine.firstDifference >= 0) return StateCheck::Differs;
    if (engine.batches.size() < static_cast<std::size_t>(result.rounds)) return StateCheck::Unknown;
    for (const EngineResult *reference : references)
        if (engine.sharesBitsWith(*reference)) return StateCheck::Same;
    references.push_back(&engine);
    return references.size() == 1 ? StateCheck::Reference : StateCheck::OtherRelease;
}

void addTotals(const EngineResult &engine, EngineSummary &summary) {
    long frames = 0, shared = 0;
    double seconds = 0;
    for (const Batch &batch : engine.batches) {
        frames += batch.frames;
        shared += batch.sharedSteps;
        summary.work += batch.work;
        seconds += secondsOf(batch.seconds, Part::Frame);
        summary.messages += batch.messages;
    }
    const auto count = static_cast<double>(frames);
    if (seconds > 0) summary.realTimeFactor = count * engine.ready.stepSize / seconds;
    if (frames > 0) summary.sharedSteps = static_cast<double>(shared) / count;
    if (!engine.batches.empty()) summary.hash = engine.batches.back().hash;
}

}  // namespace

const char *nameOf(StateCheck check) {
    switch (check) {
        case StateCheck::Reference:
            return "reference";
        case StateCheck::Same:
            return "same";
        case StateCheck::Differs:
            return "differs";
        case StateCheck::NotReproducible:
            return "not reproducible";
        case StateCheck::OwnBits:
            return "own bits";
        case StateCheck::OtherRelease:
            return "other release";
        case StateCheck::Unknown:
            return "unknown";
    }
    return "";
}

std::vector<EngineSummary> summarize(const WorldResult &result) {
    std::vector<EngineSummary> summaries;
    std::vector<const EngineResult *> references;
    const EngineResult &first = result.engines.front();
    for (const EngineResult &engine : result.engines) {
        EngineSummary summary;
        summary.engine = engine.engine.name();
        summary.failure = engine.failure;
        for (Part part : kParts)
            summary.parts[static_cast<std::size_t>(part)] = {
                engine.average(part).summary(),
                support::spreadOf(support::pairedRatios(first.seconds(part), engine.seconds(part)))};
        addTotals(engine, summary);
        summary.check = stateCheck(result, engine, references);
        summaries.push_back(summary);
    }
    return summaries;
}

}  // namespace bench
