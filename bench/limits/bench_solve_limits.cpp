// What limits the triangular solves of dWorldStep on this machine (docs/notes/2026-11-step-limits.md). Each result of L' x = b is upstream's sum,
// less products with the results of its group of four, the last one found last: so from one result to the next there are a multiplication and a
// subtraction, whatever the order of everything else. `chain` is that latency; a solve takes no less than (rows - 1) times it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include "dynamics/world_step/kernels/dxTriangle.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"

namespace {

constexpr unsigned kChainLength = 1000;

void addTimeOfARow(benchmark::State &state, unsigned rows) {
    state.counters["ns/row"] = benchmark::Counter(
        rows * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void chain(benchmark::State &state) {
    dReal factor = dReal(0.5), result = 1;
    benchmark::DoNotOptimize(factor);
    for (auto _ : state) {
        for (unsigned i = 0; i < kChainLength; ++i) result = factor - factor * result;
        benchmark::DoNotOptimize(result);
    }
    addTimeOfARow(state, kChainLength);
}

void transposed(benchmark::State &state) {
    const auto rows = static_cast<unsigned>(state.range(0));
    const std::size_t skip = (rows + 7) / 8 * 8;
    std::mt19937 random(1);
    std::uniform_real_distribution<dReal> number(-0.1, 0.1);
    std::vector<dReal> elements(skip * rows);
    std::generate(elements.begin(), elements.end(), [&] { return number(random); });
    std::vector<const dReal *> L(rows);
    for (unsigned i = 0; i < rows; ++i) L[i] = &elements[skip * i];
    std::vector<dReal> rightSide(rows), x(rows + 8);
    std::generate(rightSide.begin(), rightSide.end(), [&] { return number(random); });
    for (auto _ : state) {
        // The result found last enters the right-hand side read first: as in the LCP solver, a solve waits for the one before it.
        const dReal before = x[0];
        std::copy(rightSide.begin(), rightSide.end(), x.begin());
        x[rows - 1] += before;
        dxSolveL1Transposed(L.data(), x.data(), rows, dxSkyline(), nullptr);
        benchmark::DoNotOptimize(x.data());
        benchmark::ClobberMemory();
    }
    addTimeOfARow(state, rows);
}

BENCHMARK(chain);
BENCHMARK(transposed)->Arg(8)->Arg(12)->Arg(16)->Arg(20)->Arg(24)->Arg(34)->Arg(60)->Arg(120);

}  // namespace
