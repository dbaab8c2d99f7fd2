// Workers compute in the floating-point environment of the caller.
#include <cfenv>
#include <limits>

#include "ManagerKinds.h"
#include "Runs.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

double third() {
    volatile double one = 1, three = 3;
    return one / three;
}

double halfOfSmallest() {
    volatile double smallest = std::numeric_limits<double>::min();
    return smallest / 2;
}

// Evaluates the function once on each of four threads.
std::vector<double> onEveryWorker(dxThreadManager &manager, double (*function)()) {
    std::vector<double> results(4);
    Meeting meeting(4);
    runBlocks(manager, 4, 4, [&](unsigned, unsigned worker) {
        meeting.attend();
        results[worker] = function();
    });
    return results;
}

TEST_P(ThreadManagerTest, WorkersTakeOverTheRoundingMode) {
    const auto manager = GetParam().make(4);
    const double nearest = third();
    for (const int mode : {FE_UPWARD, FE_TONEAREST, FE_DOWNWARD, FE_TONEAREST}) {
        std::fesetround(mode);
        const double expected = third();
        const std::vector<double> results = onEveryWorker(*manager, third);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(expected != nearest, mode == FE_UPWARD);
        EXPECT_EQ(results, std::vector<double>(4, expected)) << "mode " << mode;
    }
}

#if defined(__x86_64__)
TEST_P(ThreadManagerTest, WorkersTakeOverFlushToZero) {
    const auto manager = GetParam().make(4);
    for (const bool flush : {true, false}) {
        const unsigned before = _mm_getcsr();
        if (flush) _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        const std::vector<double> results = onEveryWorker(*manager, halfOfSmallest);
        _mm_setcsr(before);
        EXPECT_EQ(results, std::vector<double>(4, flush ? 0.0 : halfOfSmallest()));
    }
}
#endif

TEST_P(ThreadManagerTest, CallerSeesTheExceptionFlagsOfWorkers) {
    const auto manager = GetParam().make(2);
    for (const bool divide : {true, false}) {
        std::feclearexcept(FE_ALL_EXCEPT);
        Meeting meeting(2);
        runBlocks(*manager, 2, 2, [&](unsigned, unsigned worker) {
            meeting.attend();
            volatile double zero = 0, quotient = 0;
            if (worker == 1 && divide) quotient = 1 / zero;
            static_cast<void>(quotient);
        });
        EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO) != 0, divide);
    }
}

}  // namespace
