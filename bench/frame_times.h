// How frame times are distributed: a histogram with bins of equal ratio, so that microseconds and seconds have the same resolution
// and millions of frames take no memory.
#pragma once

#include <map>

namespace bench {

class FrameTimes {
public:
    static constexpr int kBinsPerDoubling = 8;  // a bin is 9 % wide

    void add(double seconds);
    void add(int bin, long frames) { m_counts[bin] += frames; }
    FrameTimes &operator+=(const FrameTimes &other);

    // Number of frames by bin: bin b holds times from lowerBound(b) to lowerBound(b + 1). Only bins that hold some.
    const std::map<int, long> &counts() const { return m_counts; }
    static double lowerBound(int bin);  // s

private:
    std::map<int, long> m_counts;
};

}  // namespace bench
