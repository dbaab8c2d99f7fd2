#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace support {

namespace {

double quantileOfSorted(const std::vector<double> &sorted, double q) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double place = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size()) return sorted.back();
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

}  // namespace

double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    return quantileOfSorted(values, q);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

Spread spreadOf(const std::vector<double> &values) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return {quantileOfSorted(sorted, 0.5), quantileOfSorted(sorted, 0.25), quantileOfSorted(sorted, 0.75),
            quantileOfSorted(sorted, 0.05), quantileOfSorted(sorted, 0.95)};
}

MeanAndDeviation meanAndDeviation(const std::vector<double> &values) {
    if (values.empty()) return {std::numeric_limits<double>::quiet_NaN(), 0};
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    if (values.size() < 2) return {mean, 0};
    double squares = 0;
    for (double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count - 1))};
}

std::vector<double> pairedRatios(const std::vector<double> &reference, const std::vector<double> &other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(reference.size(), other.size()); ++i)
        if (reference[i] > 0 && other[i] > 0) ratios.push_back(reference[i] / other[i]);
    return ratios;
}

}  // namespace support
