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

// The largest of them that is not above `frames`, but at least 1.
int roundDown(double frames) {
    int best = 1;
    for (int power = 1; power <= kMost; power *= 10)
        for (int digit : {1, 2, 5})
            if (digit * power <= frames) best = digit * power;
    return std::min(best, kMost);
}

}  // namespace

int batchSize(double fastest, double slowest) {
    const int wanted = fastest > kTarget / kMost ? std::max(roundUp(kTarget / fastest), kFewest) : kMost;
    return slowest * wanted > kLongest ? roundDown(kLongest / slowest) : wanted;
}

}  // namespace bench
