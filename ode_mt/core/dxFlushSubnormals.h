// Takes subnormal numbers as 0 during its lifetime, in the calling thread. An operation on one takes more than a hundred cycles. Floats are subnormal
// below 1e-38, and the velocities of bodies that come to rest become so small.
//
// The other settings of the thread's floating-point environment, as traps and rounding, stay. On processors other than x86 it does nothing.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

class dxFlushSubnormals {
public:
    dxFlushSubnormals() : m_before(read()) { write(m_before | kFlush); }
    ~dxFlushSubnormals() { write((read() & ~kFlush) | (m_before & kFlush)); }
    dxFlushSubnormals(const dxFlushSubnormals &) = delete;
    dxFlushSubnormals &operator=(const dxFlushSubnormals &) = delete;

private:
    static constexpr unsigned kFlush = 1u << 15 | 1u << 6;  // of MXCSR: results, and operands

#ifdef __SSE2__
    static unsigned read() { return _mm_getcsr(); }
    static void write(unsigned settings) { _mm_setcsr(settings); }
#else
    static unsigned read() { return 0; }
    static void write(unsigned) {}
#endif

    const unsigned m_before;
};
