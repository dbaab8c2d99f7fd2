#include "remote/islands/dxPackedSolver.h"

#include <ode/ode_MT.h>

#include <algorithm>
#include <cfenv>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "core/dxMixedBits.h"
#include "remote/islands/dxPackedProblem.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/exact/dxDantzig.h"
#include "dynamics/world_step/exact/dxUpstreamLcp.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/dxUpstreamScope.h"

namespace {

constexpr unsigned kPair = 2;
constexpr unsigned kAlignment = 64;  // bytes, of arrays that SIMD kernels read

// Keeps messages for the coordinator, which reports them in its own order. Errors end the scope.
class KeptMessages final : public dxUpstreamScope {
public:
    std::uint32_t takeBlock(std::uint64_t) override { return 0; }
    bool defersMoved() const override { return true; }
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override {
        if (kind != dxReport::Message) throw dxUpstreamInterrupted();
        char text[1024];
        const int length = std::vsnprintf(text, sizeof text, format, arguments);
        if (length < 0 || length >= static_cast<int>(sizeof text)) throw dxUpstreamInterrupted();  // the coordinator has room for it
        const dxPackedResult::Message head{number, static_cast<std::uint32_t>(length)};
        const auto *const bytes = reinterpret_cast<const std::byte *>(&head);
        m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof head);
        m_bytes.insert(m_bytes.end(), reinterpret_cast<const std::byte *>(text), reinterpret_cast<const std::byte *>(text) + length);
        ++m_count;
        return true;
    }

    unsigned count() const { return m_count; }
    const std::vector<std::byte> &bytes() const { return m_bytes; }

private:
    unsigned m_count = 0;
    std::vector<std::byte> m_bytes;
};

// One that a thread can have, and that gets no signals.
bool isFloatMode(std::uint32_t mode) {
#ifdef __SSE2__
    constexpr std::uint32_t kBits = 0xffc0;
    return (mode & ~kBits) == 0 && (mode & _MM_MASK_MASK) == _MM_MASK_MASK;
#else
    const int rounding = static_cast<int>(mode);
    return rounding == FE_TONEAREST || rounding == FE_DOWNWARD || rounding == FE_UPWARD || rounding == FE_TOWARDZERO;
#endif
}

// The problem's floating-point mode, without flags; the thread's own afterwards.
class FloatMode {
public:
    explicit FloatMode(std::uint32_t mode) {
        std::fegetenv(&m_own);
        std::feclearexcept(FE_ALL_EXCEPT);
#ifdef __SSE2__
        _mm_setcsr(mode & ~std::uint32_t{_MM_EXCEPT_MASK});
#else
        std::fesetround(static_cast<int>(mode));
#endif
    }
    ~FloatMode() { std::fesetenv(&m_own); }
    FloatMode(const FloatMode &) = delete;
    FloatMode &operator=(const FloatMode &) = delete;

private:
    std::fenv_t m_own;
};

// More than all arrays that are taken from it, with what aligns each.
std::size_t memoryFor(const dxPackedCounts &counts) {
    constexpr std::size_t kSlack = 16 * kAlignment;
    const std::size_t rows = counts.rows, bodies = counts.bodies, joints = counts.joints;
    const std::size_t numbers = rows * dPAD(counts.rows) + rows * (2 * kRowElements + 2 * kPair) +
                                bodies * (dxPackedProblem::kInertiaElements + kRowElements) + dxConstraintMatrixTask::transposedSize(rows);
    return numbers * sizeof(dReal) + joints * (sizeof(dxConstraintJoint) + dxBodyLinks::kSides * sizeof(unsigned)) + bodies * sizeof(unsigned) +
           rows * sizeof(int) + dxEstimateSolveLCPMemoryReq(counts.rows, false) + kSlack;
}

template <class Element>
Element *copy(dxWorldProcessMemArena &arena, const std::byte *from, std::size_t count) {
    Element *const array = arena.AllocateOveralignedArray<Element>(count, kAlignment);
    std::memcpy(array, from, count * sizeof(Element));
    return array;
}

// May throw dxUpstreamInterrupted.
const dReal *solve(const dxPackedProblem &problem, dxWorldProcessMemArena &arena) {
    const dxPackedCounts &counts = problem.counts;
    const std::size_t rows = counts.rows, bodies = counts.bodies;
    dReal *const matrix = arena.AllocateOveralignedArray<dReal>(rows * dPAD(counts.rows), kAlignment);
    const dxConstraintJoint *const joints = copy<dxConstraintJoint>(arena, problem.joints, counts.joints);
    dReal *const pairsBX = copy<dReal>(arena, problem.pairsBX, rows * kPair), *const pairsLoHi = copy<dReal>(arena, problem.pairsLoHi, rows * kPair);
    int *const normalOf = copy<int>(arena, problem.normalOf, rows);
    void *const state = arena.SaveState();

    dxConstraintMatrixTask task;
    task.joints = joints;
    task.jointCount = counts.joints;
    task.jacobian = copy<dReal>(arena, problem.jacobian, rows * dxBodyLinks::kSides * kRowElements);
    task.inverseInertia = copy<dReal>(arena, problem.inverseInertia, bodies * dxPackedProblem::kInertiaElements);
    task.motions = copy<dReal>(arena, problem.motions, bodies * kRowElements);
    task.pairs = pairsBX;
    task.matrix = matrix;
    task.rowSkip = dPAD(counts.rows);
    task.transposed = arena.AllocateArray<dReal>(dxConstraintMatrixTask::transposedSize(rows));
    task.links.first = arena.AllocateArray<unsigned>(bodies);
    task.links.next = arena.AllocateArray<unsigned>(std::size_t(counts.joints) * dxBodyLinks::kSides);
    std::fill_n(task.links.first, bodies, dxBodyLinks::kNone);
    for (unsigned i = 0; i < counts.joints; ++i)
        for (unsigned side = 0; side < dxBodyLinks::kSides && joints[i].bodies[side] != dxConstraintJoint::kNoBody; ++side)
            task.links.add(joints[i].bodies[side], dxBodyLinks::linkOf(i, side));
    dxMakeConstraintMatrix(task, true);
    arena.RestoreState(state);

    dxSolveDantzig(nullptr, &arena, counts.rows, matrix, pairsBX, nullptr, counts.bilateralJoints, pairsLoHi, normalOf);
    return pairsBX;
}

void append(std::vector<std::byte> &bytes, const void *data, std::size_t size) {
    const auto *const from = static_cast<const std::byte *>(data);
    bytes.insert(bytes.end(), from, from + size);
}

void giveBack(std::vector<std::byte> &result) {
    const dxPackedResult::Head head{dxPackedResult::Outcome::GivenBack, 0, 0, 0};
    const auto *const bytes = reinterpret_cast<const std::byte *>(&head);
    result.assign(bytes, bytes + sizeof head);
}

}  // namespace

void dxSolvePacked(const std::byte *bytes, std::size_t size, std::vector<std::byte> &result) {
    dxPackedProblem problem;
    if (!problem.read(bytes, size) || !isFloatMode(problem.counts.floatMode)) return giveBack(result);
    const dxArenaLease arena(memoryFor(problem.counts));
    if (arena.get() == nullptr) return giveBack(result);
    try {
        KeptMessages messages;
        unsigned exceptions = 0;
        const dReal *pairsBX = nullptr;
        {
            const FloatMode mode(problem.counts.floatMode);
            pairsBX = solve(problem, *arena.get());
            exceptions = static_cast<unsigned>(std::fetestexcept(FE_ALL_EXCEPT));
        }
        const dxPackedResult::Head head{dxPackedResult::Outcome::Solved, problem.counts.rows, exceptions, messages.count()};
        result.clear();
        append(result, &head, sizeof head);
        for (unsigned i = 0; i < problem.counts.rows; ++i) append(result, pairsBX + std::size_t(i) * kPair + PBX_X, sizeof(dReal));
        result.resize(dxPackedRoom(result.size()));
        append(result, messages.bytes().data(), messages.bytes().size());
    } catch (const dxUpstreamInterrupted &) {
        giveBack(result);
    } catch (const std::bad_alloc &) {
        giveBack(result);
    }
}

namespace {

// Numbers that look random, from -1 to 1.
class Numbers {
public:
    dReal next() {
        m_state += kMixedBitsStep;
        return static_cast<dReal>(static_cast<std::int64_t>(dxMixedBits(m_state)) >> 11) / static_cast<dReal>(std::int64_t{1} << 52);
    }

private:
    std::uint64_t m_state = 0x6f64656d74;
};

// A chain of bodies, each held by a joint of three rows without limits or a contact with friction.
std::vector<std::byte> makeProblem(Numbers &numbers, unsigned bodies, std::uint32_t floatMode) {
    constexpr unsigned kRows = 3;
    const dxPackedCounts counts{floatMode, bodies, bodies, kRows * bodies, bodies / 3, 0};
    const dxPackedLayout layout(counts);
    std::vector<std::byte> bytes(layout.total);
    std::memcpy(bytes.data(), &counts, sizeof counts);
    // Aligned, as in dxPackProblem.
    auto *const joints = reinterpret_cast<dxConstraintJoint *>(bytes.data() + layout.joints);
    for (unsigned i = 0; i < bodies; ++i) joints[i] = {kRows * i, kRows, {i, i > 0 ? i - 1 : dxConstraintJoint::kNoBody}};
    const auto reals = [&bytes](std::size_t at) { return reinterpret_cast<dReal *>(bytes.data() + at); };
    std::generate_n(reals(layout.jacobian), counts.rows * dxBodyLinks::kSides * kRowElements, [&numbers] { return numbers.next(); });
    dReal *inertia = reals(layout.inverseInertia);
    for (unsigned i = 0; i < bodies; ++i) {
        const dReal mass = 2 + numbers.next();
        for (unsigned k = 0; k < dxPackedProblem::kInertiaElements; ++k)
            *inertia++ = k == dxConstraintMatrixTask::kInverseMass || k % 5 == 0 ? mass : k % 4 == 3 ? dReal(0) : numbers.next() / 8;
    }
    std::generate_n(reals(layout.motions), bodies * kRowElements, [&numbers] { return 10 * numbers.next(); });
    dReal *const pairsBX = reals(layout.pairsBX), *const pairsLoHi = reals(layout.pairsLoHi);
    int *const normalOf = reinterpret_cast<int *>(bytes.data() + layout.normalOf);
    for (unsigned i = 0; i < counts.rows; ++i) {
        const bool isUnilateral = i / kRows >= counts.bilateralJoints, isNormal = i % kRows == 0;
        pairsBX[kPair * i] = numbers.next();
        pairsBX[kPair * i + 1] = dReal(0.5);
        pairsLoHi[kPair * i] = !isUnilateral ? -dInfinity : isNormal ? dReal(0) : dReal(-0.5);
        pairsLoHi[kPair * i + 1] = !isUnilateral || isNormal ? dInfinity : dReal(0.5);
        normalOf[i] = isUnilateral && !isNormal ? static_cast<int>(i - i % kRows) : -1;
    }
    return bytes;
}

class KeptFloatEnvironment {
public:
    KeptFloatEnvironment() { std::fegetenv(&m_kept); }
    ~KeptFloatEnvironment() { std::fesetenv(&m_kept); }
    KeptFloatEnvironment(const KeptFloatEnvironment &) = delete;
    KeptFloatEnvironment &operator=(const KeptFloatEnvironment &) = delete;

private:
    std::fenv_t m_kept;
};

// Of all bits of all results but exceptions: sizes that take each kernel, and each rounding mode. Throws std::bad_alloc.
std::uint64_t digestOfSolutions() {
    constexpr unsigned kSizes[] = {1, 2, 5, 11, 24, 40};
    constexpr int kRoundings[] = {FE_TONEAREST, FE_DOWNWARD, FE_TOWARDZERO};
    const KeptFloatEnvironment own;
    Numbers numbers;
    std::uint64_t digest = 0;
    std::vector<std::byte> result;
    for (const int rounding : kRoundings) {
        std::fesetenv(FE_DFL_ENV);
        std::fesetround(rounding);
        for (const unsigned size : kSizes) {
            const std::vector<std::byte> problem = makeProblem(numbers, size, dxFloatMode());
            dxSolvePacked(problem.data(), problem.size(), result);
            if (result.size() == sizeof(dxPackedResult::Head)) throw std::bad_alloc();  // given back
            // Lanes beyond a vector's end may raise exceptions, according to what was there before.
            std::fill_n(result.begin() + offsetof(dxPackedResult::Head, exceptions), sizeof(dxPackedResult::Head::exceptions), std::byte{0});
            for (const std::byte one : result) digest = dxMixedBits(digest ^ static_cast<std::uint64_t>(one)) + kMixedBitsStep;
        }
    }
    return digest;
}

}  // namespace

dxRemoteHello dxDescribeSolver() {
    dxRemoteHello hello;
    std::snprintf(hello.version, sizeof hello.version, "%s", dODE_MT_VERSION);
    hello.realSize = sizeof(dReal);
    hello.digest = digestOfSolutions();
    return hello;
}
