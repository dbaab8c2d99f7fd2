// The measurement: all engines run the same frames of the same world, interleaved.
//
// Only one engine runs at a time. In a round each runs one batch of the same number of frames; the
// order rotates from round to round, so that none always comes first. Times of one round belong
// together as pairs: what slows the machine down for a second slows both.
#pragma once

#include "competitor.h"
#include "stopping_rule.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bench {

struct EngineResult {
    Engine engine;
    Ready ready;
    std::vector<Batch> batches;                          // one a round, until it failed
    std::array<RunningAverage, kParts.size()> averages;  // by Part
    std::string failure;                                 // empty: it ran to the end
    long firstDifference = -1;  // frames after which its state was found to differ; -1: never

    const RunningAverage &average(Part part) const { return averages[static_cast<std::size_t>(part)]; }
    std::vector<double> seconds(Part part) const;  // one value a batch
    bool failed() const { return !failure.empty(); }
    bool callbacksTimed() const;

    // Returns whether its states should be those of another engine: both have upstream's bits, and not of releases known to differ.
    bool sharesBitsWith(const EngineResult &other) const;
};

struct WorldResult {
    std::string world;
    std::vector<EngineResult> engines;  // the first is the one that ratios refer to
    int rounds = 0;
    long warmUpFrames = 0;
    long frames = 0;     // measured, warm-up not counted
    double seconds = 0;  // of measuring, all engines together
    StoppingRule::Verdict verdict = StoppingRule::Verdict::GoOn;

    bool callbacksTimed() const;  // of any engine
    bool hasSeveralReleases() const;  // of ODE, known ones, in the libraries of its engines

    // All engines ran to the end with the same states, but for those that are not reproducible or of another release.
    bool isClean() const;
};

struct RaceSettings {
    StoppingRule stop;
    long warmUpFrames = 100;
    double warmUpSeconds = 1;  // of the first engine; the others run as many frames
};

using Competitors = std::vector<std::unique_ptr<Competitor>>;

// `onRound` sees the result so far after each round. An engine that fails takes no part from then on.
WorldResult race(const std::string &world, Competitors &competitors, const RaceSettings &settings,
                 const std::function<void(const WorldResult &)> &onRound);

}  // namespace bench
