#include "clusters/heuristics/dxMedian.h"

#include <algorithm>
#include <cstddef>

double dxMedian(std::vector<double> &numbers) {
    if (numbers.empty()) return 0;
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>((numbers.size() - 1) / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}
