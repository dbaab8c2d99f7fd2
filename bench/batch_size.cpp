#include "batch_size.h"

#include <algorithm>

namespace bench {

namespace {

constexpr double kTarget = 0.050;  // s
constexpr double kLongest = 2.0;   // s
constexpr int kFewest = 5;         // frames, where they take less than kLongest
constexpr int kMost = 10'000;      // frames, also if the clock shows no time at all

// The smallest of 1, 2, 5, 10, 20, 50, … that is not below `frames`.
int roundUp(double frames) {
    for (int power = 1; power < kMost; power *= 10)
        for (int digit : {1, 2, 5})
            if (digit * power >= frames) return digit * power;
    return kMost;
}

}  // namespace

int batchSize(double secondsPerFrame) {
    if (!(secondsPerFrame > kTarget / kMost)) return kMost;
    const int frames = std::max(roundUp(kTarget / secondsPerFrame), kFewest);
    if (frames * secondsPerFrame <= kLongest) return frames;
    return 2 * secondsPerFrame <= kLongest ? 2 : 1;
}

}  // namespace bench
