#include "support/text.h"
#include "number_text.h"
#include "report.h"
#include "summary.h"

#include <cmath>
#include <vector>

namespace bench {

namespace {

// Returns the place of the fastest engine of ours; -1 if there is none beside the reference.
long fastestOfOurs(const WorldResult &result, const std::vector<EngineSummary> &summaries) {
    long fastest = -1;
    double most = 0;
    for (std::size_t i = 1; i < summaries.size(); ++i) {
        const double speedUp = summaries[i].part(Part::Frame).speedUp.median;
        const bool hasBits = summaries[i].check == StateCheck::Same || summaries[i].check == StateCheck::OtherRelease;
        const bool isComparable = summaries[i].failure.empty() && hasBits;
        if (!result.engines[i].engine.isOurs() || !isComparable || !(speedUp > most)) continue;
        most = speedUp;
        fastest = static_cast<long>(i);
    }
    return fastest;
}

// What the first engine is, for people who have not chosen it.
std::string inPlainWords(const std::string &engine) { return engine == "stock" ? "libode8" : engine; }

}  // namespace

std::string reportSentence(const std::vector<WorldResult> &results) {
    std::string text;
    bool areClean = true, areOfOneRelease = true;
    for (const WorldResult &result : results) {
        areClean = result.isClean() && areClean;
        const std::vector<EngineSummary> summaries = summarize(result);
        const long fastest = fastestOfOurs(result, summaries);
        if (fastest < 0) continue;
        const EngineSummary &engine = summaries[static_cast<std::size_t>(fastest)];
        const std::string &release = result.engines[static_cast<std::size_t>(fastest)].ready.release;
        areOfOneRelease = !areOtherReleases(result.engines[0].ready.release, release) && areOfOneRelease;
        const std::string factor = numberText(engine.part(Part::Frame).speedUp.median) + " times";
        text += text.empty() ? "ODE_MT runs at " + factor + " the speed of " + inPlainWords(summaries[0].engine) : ", at " + factor;
        text += " on " + support::printable(result.world) + " (" + engine.engine + ")";
    }
    if (text.empty()) return text;
    if (areClean && !areOfOneRelease) return text + "; the releases of ODE differ, so results may.\n";
    return text + (areClean ? ", with the same results in every bit.\n" : "; an engine failed or gave other results.\n");
}

}  // namespace bench
