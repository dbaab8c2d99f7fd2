#include "batch_size.h"

#include <algorithm>

namespace bench {

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
