#include "running_average.h"

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

}  // namespace bench
