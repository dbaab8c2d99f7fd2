// Medians, quantiles and deviations of measured figures.
#pragma once

#include <vector>

namespace support {

struct Spread {
    double median, lowerQuartile, upperQuartile, percentile5, percentile95;
};

struct MeanAndDeviation {
    double mean, deviation;  // deviation: of a sample (n - 1); 0 for fewer than two values
};

// The value below which a share `q` (0 to 1) of the values lies, interpolated linearly between
// neighbours. NaN if there are none.
double quantile(std::vector<double> values, double q);
double median(std::vector<double> values);

Spread spreadOf(const std::vector<double> &values);
MeanAndDeviation meanAndDeviation(const std::vector<double> &values);

// reference[i] / other[i], of pairs measured in the same round. A pair with a zero or negative time is
// ignored: the clock did not resolve it.
std::vector<double> pairedRatios(const std::vector<double> &reference, const std::vector<double> &other);

}  // namespace support
