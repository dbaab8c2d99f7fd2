// The floating-point environment of a run: rounding mode, flush-to-zero, denormals-are-zero, exception
// masks and flags. Same bits need the same environment on every thread. A thread begins with the one that its
// creator had at that time, so workers take the caller's for as long as they work for it, and give it the exception flags that they raised.
//
// Threading: the caller captures and raises, workers have scopes.
#pragma once

#include <atomic>
#include <cfenv>
#include <cstdint>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

// Returns how the calling thread computes: rounding, denormals, masks of exceptions, without the flags raised so far. Two
// computations in the same mode have the same results.
inline std::uint32_t dxFloatMode() {
#ifdef __SSE2__
    return _mm_getcsr() & ~std::uint32_t{_MM_EXCEPT_MASK};
#else
    return static_cast<std::uint32_t>(std::fegetround());
#endif
}

// Returns whether the calling thread gets a signal for floating-point exceptions. A program that asked for it expects the
// signal on the thread that called the library, so workers get nothing then.
bool dxTrapsFloatingPoint();

// Returns whether the calling thread rounds to nearest and gets no signal for floating-point exceptions, as nearly every program. Then a sum of
// negated terms is the negated sum, and code may compute more than it uses.
inline bool dxIsPlainFloatMode() {
#ifdef __SSE2__
    return (_mm_getcsr() & (_MM_MASK_MASK | _MM_ROUND_MASK)) == _MM_MASK_MASK;
#else
    return std::fegetround() == FE_TONEAREST && !dxTrapsFloatingPoint();
#endif
}

class dxFloatEnvironment {
public:
    // Stores the calling thread's environment, for scopes of other threads.
    void capture();

    // Sets the flags that workers raised, on the calling thread, without trapping.
    void raiseFlags() const;

private:
    friend class dxFloatEnvironmentScope;
    std::fenv_t m_environment{};
    std::atomic<unsigned> m_raised{0};  // exception flags, as std::fetestexcept gives them
};

// Sets the environment for the calling thread; the destructor restores the thread's own.
class dxFloatEnvironmentScope {
public:
    explicit dxFloatEnvironmentScope(dxFloatEnvironment &environment);
    ~dxFloatEnvironmentScope();
    dxFloatEnvironmentScope(const dxFloatEnvironmentScope &) = delete;
    dxFloatEnvironmentScope &operator=(const dxFloatEnvironmentScope &) = delete;

    // Adds the flags raised so far; called before a block is reported as finished.
    void shareFlags();

private:
    dxFloatEnvironment &m_shared;
    unsigned m_known;  // flags that have been added
    std::fenv_t m_own;
};
