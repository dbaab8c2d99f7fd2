#include "heuristics/dxHeuristicAlert.h"

#include <cmath>

namespace {

bool differ(double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); }

}  // namespace

bool dxHeuristicAlert::valid() const {
    return m_kind == Kind::FixedInterval ? m_interval > 0 : !std::isnan(m_threshold);
}

bool dxHeuristicAlert::fires(const dxAlertSample &sample) {
    switch (m_kind) {
        case Kind::FixedInterval:
            return m_interval > 0 && sample.frame % m_interval == 0;
        case Kind::ValueChange:
            return sample.frame > 1 && differ(sample.value, sample.previous);
        case Kind::ValueBelow:
        case Kind::ValueAbove:
            return crosses(sample.value);
        case Kind::SpeedBelow:
        case Kind::SpeedAbove:
            return crosses(sample.speed);
    }
    return false;
}

bool dxHeuristicAlert::crosses(double number) {
    if (std::isnan(number)) return false;
    const bool below = m_kind == Kind::ValueBelow || m_kind == Kind::SpeedBelow;
    const bool before = m_beyond;
    m_beyond = below ? number < m_threshold : number > m_threshold;
    return m_beyond && !before;
}
