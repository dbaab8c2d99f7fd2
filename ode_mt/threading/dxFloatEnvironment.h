// The floating-point environment of a run: rounding mode, flush-to-zero, denormals-are-zero, exception
// masks and flags. Same bits need the same environment on every thread, and a thread has the one its
// creator had long ago (trap 9 of the design), so workers take over the caller's for as long as they
// work for it and hand back the exception flags they raised.
#pragma once

#include <atomic>
#include <cfenv>
#include <cstdint>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

// How the calling thread computes: rounding, denormals, masks of exceptions, not the flags raised so far. Results of two
// computations in the same mode are the same.
inline std::uint32_t dxFloatMode() {
#ifdef __SSE2__
    return _mm_getcsr() & ~std::uint32_t{_MM_EXCEPT_MASK};
#else
    return static_cast<std::uint32_t>(std::fegetround());
#endif
}

// Whether the calling thread gets a signal for floating-point exceptions. A program that asked for it expects the
// signal on the thread that called the library, so that nothing is given to workers then.
bool dxTrapsFloatingPoint();

// Whether the calling thread rounds to nearest and gets no signal for floating-point exceptions, as nearly every program. Then the sign of
// a sum is that of its terms, turned round, and more may be computed than is used.
inline bool dxIsPlainFloatMode() {
#ifdef __SSE2__
    return (_mm_getcsr() & (_MM_MASK_MASK | _MM_ROUND_MASK)) == _MM_MASK_MASK;
#else
    return std::fegetround() == FE_TONEAREST && !dxTrapsFloatingPoint();
#endif
}

class dxFloatEnvironment {
public:
    // The calling thread's environment, to be taken over by others.
    void capture();

    // Sets the flags that workers raised on the calling thread, without trapping.
    void raiseFlags() const;

private:
    friend class dxFloatEnvironmentScope;
    std::fenv_t environment{};
    std::atomic<unsigned> raised{0};  // exception flags, as std::fetestexcept gives them
};

// Takes over the environment; the destructor restores the thread's own.
class dxFloatEnvironmentScope {
public:
    explicit dxFloatEnvironmentScope(dxFloatEnvironment &shared);
    ~dxFloatEnvironmentScope();
    dxFloatEnvironmentScope(const dxFloatEnvironmentScope &) = delete;
    dxFloatEnvironmentScope &operator=(const dxFloatEnvironmentScope &) = delete;

    // Adds the flags raised so far; called before a block is reported as finished.
    void shareFlags();

private:
    dxFloatEnvironment &shared;
    unsigned known;
    std::fenv_t own;
};
