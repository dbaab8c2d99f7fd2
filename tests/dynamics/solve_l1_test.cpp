// The triangular solves give upstream's bits: for every instruction set of this machine, size, stride and row
// skip, whatever the values.
#include "instruction_sets.h"
#include "dynamics/world_step/kernels/dxSolveL1.h"
#include "sanitizers.h"
#include "upstream_solve_l1.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using Limits = std::numeric_limits<dReal>;
using Solve = std::function<void(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip)>;
using Values = std::function<dReal(std::mt19937 &)>;

// Small enough that solutions of a thousand rows stay finite.
dReal ordinary(std::mt19937 &random) { return std::uniform_real_distribution<dReal>(-0.2, 0.2)(random); }

// Sums of such values round differently in every order.
dReal manyDecades(std::mt19937 &random) {
    const dReal decade = std::uniform_real_distribution<dReal>(-9, 3)(random);
    return std::copysign(std::pow(dReal(10), decade), ordinary(random));
}

dReal withZerosAndDenormals(std::mt19937 &random) {
    switch (random() % 6) {
        case 0:
            return 0;
        case 1:
            return -dReal(0);
        case 2:
            return std::copysign(Limits::denorm_min() * dReal(1 + random() % 1000), ordinary(random));
        case 3:
            return std::copysign(Limits::min(), ordinary(random));
        default:
            return ordinary(random);
    }
}

// Rare enough that finite results remain.
dReal withInfinitiesAndNaN(std::mt19937 &random) {
    switch (random() % 4096) {
        case 0:
            return Limits::infinity();
        case 1:
            return -Limits::infinity();
        case 2:
            return Limits::quiet_NaN();
        case 3:
            return Limits::max();
        default:
            return withZerosAndDenormals(random);
    }
}

struct Kind {
    const char *name;
    Values values;
};
const Kind kKinds[] = {{"ordinary", ordinary},
                       {"many decades", manyDecades},
                       {"zeros and denormals", withZerosAndDenormals},
                       {"infinities and NaN", withInfinitiesAndNaN}};

struct System {
    unsigned rowCount, rowSkip;
    std::vector<dReal> L, B;  // B with room for stride 2
};

// What may not be read, the diagonal and all above it, is NaN; so are B's elements between the strides.
System makeSystem(unsigned rowCount, unsigned rowSkip, unsigned stride, const Values &values,
                  std::mt19937 &random) {
    System system{rowCount, rowSkip, {}, {}};
    system.L.assign(std::size_t(rowCount) * rowSkip, Limits::quiet_NaN());
    system.B.assign(std::size_t(rowCount) * stride, Limits::quiet_NaN());
    for (unsigned row = 0; row < rowCount; ++row) {
        for (unsigned column = 0; column < row; ++column)
            system.L[std::size_t(row) * rowSkip + column] = values(random);
        system.B[row * stride] = values(random);
    }
    return system;
}

bool sameBits(dReal a, dReal b) {
    return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof(dReal)) == 0;
}

std::string firstDifference(const System &system, const Solve &ours, const Solve &theirs) {
    std::vector<dReal> mine = system.B, upstream = system.B;
    ours(system.L.data(), mine.data(), system.rowCount, system.rowSkip);
    theirs(system.L.data(), upstream.data(), system.rowCount, system.rowSkip);
    for (std::size_t i = 0; i < mine.size(); ++i) {
        if (!sameBits(mine[i], upstream[i])) {
            return "element " + std::to_string(i) + " is " + std::to_string(mine[i]) + ", upstream's " +
                   std::to_string(upstream[i]);
        }
    }
    return {};
}

unsigned padded(unsigned rowCount) { return dPAD(rowCount); }

std::vector<unsigned> allSizes() {
    std::vector<unsigned> sizes;
    for (unsigned rowCount = 1; rowCount <= 150; ++rowCount) sizes.push_back(rowCount);
    for (unsigned rowCount = 151; rowCount <= 300; rowCount += 3) sizes.push_back(rowCount);
    for (unsigned rowCount : {511u, 512u, 513u, 520u, 599u, 1000u, 1024u, 1031u}) sizes.push_back(rowCount);
    return sizes;
}

template <unsigned Stride>
void expectUpstreamsBits(const Solve &ours, const Solve &theirs) {
    const std::vector<std::int64_t> sets = instructionSets();
    ASSERT_FALSE(sets.empty());
    std::mt19937 random(1);
    for (const Kind &kind : kKinds) {
        for (unsigned rowCount : allSizes()) {
            for (unsigned rowSkip : {padded(rowCount), padded(rowCount) + 20, rowCount + 3}) {
                const System system = makeSystem(rowCount, rowSkip, Stride, kind.values, random);
                for (std::int64_t set : sets) {
                    onInstructionSet(set, [&] {
                        ASSERT_EQ(firstDifference(system, ours, theirs), "")
                            << kind.name << ", " << rowCount << " rows, row skip " << rowSkip;
                    });
                    if (::testing::Test::HasFatalFailure()) return;
                }
            }
        }
    }
}

// The functions that are looked up call none of the library's other exported ones, so this is a precaution, and
// one that AddressSanitizer does not allow.
#ifdef ODE_MT_ADDRESS_SANITIZER
constexpr int kOwnSymbolsFirst = 0;
#else
constexpr int kOwnSymbolsFirst = RTLD_DEEPBIND;
#endif

// A function of Debian's library, whatever this program is linked with.
using PublicSolve = void(const dReal *, dReal *, int, int);
PublicSolve *debianFunction(const char *name) {
    static void *library = dlopen(ODE_MT_DEBIAN_ODE, RTLD_NOW | RTLD_LOCAL | kOwnSymbolsFirst);
    return library ? reinterpret_cast<PublicSolve *>(dlsym(library, name)) : nullptr;
}

TEST(SolveL1, StraightGivesUpstreamsBits) {
    expectUpstreamsBits<1>(dxSolveL1Straight<1>, upstreamSolveStraight<1>);
}

TEST(SolveL1, StraightGivesUpstreamsBitsAtStrideTwo) {
    expectUpstreamsBits<2>(dxSolveL1Straight<2>, upstreamSolveStraight<2>);
}

TEST(SolveL1, TransposedGivesUpstreamsBits) {
    expectUpstreamsBits<1>(dxSolveL1Transposed<1>, upstreamSolveTransposed<1>);
}

TEST(SolveL1, TransposedGivesUpstreamsBitsAtStrideTwo) {
    expectUpstreamsBits<2>(dxSolveL1Transposed<2>, upstreamSolveTransposed<2>);
}

#ifdef dDOUBLE
TEST(SolveL1, StraightGivesTheBitsOfDebiansBinary) {
    PublicSolve *debian = debianFunction("dSolveL1");
    ASSERT_NE(debian, nullptr);
    expectUpstreamsBits<1>(dxSolveL1Straight<1>, debian);
}

TEST(SolveL1, TransposedGivesTheBitsOfDebiansBinary) {
    PublicSolve *debian = debianFunction("dSolveL1T");
    ASSERT_NE(debian, nullptr);
    expectUpstreamsBits<1>(dxSolveL1Transposed<1>, debian);
}
#endif

// The comparison sees an order of additions that is not upstream's.
TEST(SolveL1, ComparisonSeesAnotherOrderOfAdditions) {
    const Solve backwards = [](const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
        for (unsigned row = 0; row < rowCount; ++row) {
            dReal sum = 0;
            for (unsigned column = row; column-- > 0;)
                sum += L[std::size_t(row) * rowSkip + column] * B[column];
            B[row] -= sum;
        }
    };
    std::mt19937 random(1);
    for (const Values &values : {Values(ordinary), Values(manyDecades)}) {
        EXPECT_NE(firstDifference(makeSystem(40, 40, 1, values, random), backwards, upstreamSolveStraight<1>),
                  "");
    }
}

}  // namespace
