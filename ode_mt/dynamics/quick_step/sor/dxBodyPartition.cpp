#include "dynamics/quick_step/sor/dxBodyPartition.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace {

constexpr std::size_t kBins = 256;

// Where bodies lie along one axis, as numbers of bins.
class Axis {
public:
    Axis(int axis, dReal low, dReal high) : m_axis(axis), m_low(low), m_perUnit(kBins / (high - low)) {}

    // Places that are no numbers, or not finite, are in one of the outer bins.
    std::size_t binOf(const dxPlace &place) const {
        const dReal bin = (place.at[m_axis] - m_low) * m_perUnit;
        if (!(bin > 0)) return 0;
        return bin < dReal(kBins - 1) ? static_cast<std::size_t>(bin) : kBins - 1;
    }

private:
    int m_axis;
    dReal m_low, m_perUnit;
};

Axis longestAxis(const std::vector<dxPlace> &places, const unsigned *begin, const unsigned *end) {
    dReal low[3], high[3];
    std::fill(low, low + 3, std::numeric_limits<dReal>::max());
    std::fill(high, high + 3, std::numeric_limits<dReal>::lowest());
    for (const unsigned *body = begin; body != end; ++body)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], places[*body].at[axis]);
            high[axis] = std::max(high[axis], places[*body].at[axis]);
        }
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
    return {longest, low[longest], high[longest]};
}

// The first bin that is no longer among those that have `share` of the weight.
std::size_t splitAt(const std::size_t *weightOfBin, double share) {
    const double wanted = share * static_cast<double>(std::accumulate(weightOfBin, weightOfBin + kBins, std::size_t{0}));
    double sum = 0;
    std::size_t bin = 0;
    while (bin < kBins && sum + static_cast<double>(weightOfBin[bin]) / 2 < wanted)
        sum += static_cast<double>(weightOfBin[bin++]);
    return bin;
}

}  // namespace

void dxBodyPartition::partition(const std::vector<dxPlace> &places, const std::vector<unsigned> &weights, unsigned parts) {
    m_partition.resize(places.size());  // each is written below
    m_bodies.resize(places.size());
    std::iota(m_bodies.begin(), m_bodies.end(), 0u);
    m_open.assign(1, {0, places.size(), 0, parts});
    while (!m_open.empty()) {
        const Bisection whole = m_open.back();
        m_open.pop_back();
        unsigned *const begin = m_bodies.data() + whole.begin, *const end = m_bodies.data() + whole.end;
        if (whole.parts == 1) {
            for (const unsigned *body = begin; body != end; ++body) m_partition[*body] = static_cast<Partition>(whole.firstPart);
            continue;
        }
        const Axis axis = longestAxis(places, begin, end);
        std::size_t weightOfBin[kBins] = {};
        for (const unsigned *body = begin; body != end; ++body) weightOfBin[axis.binOf(places[*body])] += weights[*body];
        const unsigned left = whole.parts / 2;
        const std::size_t split = splitAt(weightOfBin, double(left) / whole.parts);
        const unsigned *const middle =
            std::partition(begin, end, [&](unsigned body) { return axis.binOf(places[body]) < split; });
        const std::size_t at = static_cast<std::size_t>(middle - m_bodies.data());
        m_open.push_back({whole.begin, at, whole.firstPart, left});
        m_open.push_back({at, whole.end, whole.firstPart + left, whole.parts - left});
    }
}
