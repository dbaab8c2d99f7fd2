#include "stopping_rule.h"

#include <algorithm>
#include <limits>

namespace bench {

void RunningAverage::add(int frames, double seconds) {
    const long valuesBefore = m_frames / kFramesPerValue;
    m_frames += frames;
    m_seconds += seconds;
    if (m_frames / kFramesPerValue > valuesBefore)
        m_kept.push_back(m_seconds / static_cast<double>(m_frames));
}

support::MeanAndDeviation RunningAverage::summary() const {
    if (!m_kept.empty()) return support::meanAndDeviation(m_kept);
    return support::meanAndDeviation(m_frames ? std::vector<double>{m_seconds / static_cast<double>(m_frames)}
                                     : std::vector<double>{});
}

double RunningAverage::relativeSpread() const {
    if (m_kept.size() < kValuesCompared) return std::numeric_limits<double>::infinity();
    const std::vector<double> last(m_kept.end() - kValuesCompared, m_kept.end());
    const auto [smallest, largest] = std::minmax_element(last.begin(), last.end());
    return (*largest - *smallest) / support::meanAndDeviation(last).mean;
}

StoppingRule::Verdict StoppingRule::judge(const std::vector<RunningAverage> &averages, int rounds,
                                          double seconds, long frames) const {
    const bool stable = std::all_of(averages.begin(), averages.end(), [this](const RunningAverage &average) {
        return average.relativeSpread() <= tolerance;
    });
    if (stable && rounds >= minimumRounds && seconds >= minimumSeconds) return Verdict::Stable;
    if (frames >= maximumFrames) return Verdict::OutOfFrames;
    if (seconds >= maximumSeconds) return Verdict::OutOfTime;
    return Verdict::GoOn;
}

std::string toString(StoppingRule::Verdict verdict) {
    switch (verdict) {
        case StoppingRule::Verdict::GoOn:
            return "not finished";
        case StoppingRule::Verdict::Stable:
            return "averages stable";
        case StoppingRule::Verdict::OutOfTime:
            return "time limit, averages not yet stable";
        case StoppingRule::Verdict::OutOfFrames:
            return "frame limit, averages not yet stable";
    }
    return "";
}

namespace {

constexpr double kTarget = 0.050;  // s
constexpr double kMaxTime = 2.0;   // s
constexpr int kMin = 5;         // frames, where they take less than kMaxTime
constexpr int kMax = 10'000;      // frames, also if the clock shows no time at all

// The smallest of 1, 2, 5, 10, 20, 50, … that is not below `frames`.
int roundUp(double frames) {
    for (int power = 1; power < kMax; power *= 10)
        for (int digit : {1, 2, 5})
            if (digit * power >= frames) return digit * power;
    return kMax;
}

// The largest of them that is not above `frames`, but at least 1.
int roundDown(double frames) {
    int best = 1;
    for (int power = 1; power <= kMax; power *= 10)
        for (int digit : {1, 2, 5})
            if (digit * power <= frames) best = digit * power;
    return std::min(best, kMax);
}

}  // namespace

int batchSize(double fastest, double slowest) {
    const int wanted = fastest > kTarget / kMax ? std::max(roundUp(kTarget / fastest), kMin) : kMax;
    return slowest * wanted > kMaxTime ? roundDown(kMaxTime / slowest) : wanted;
}

}  // namespace bench
