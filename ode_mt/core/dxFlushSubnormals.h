// Takes subnormal numbers as 0 during its lifetime, in the calling thread. An operation on one takes more than a hundred cycles. Floats are subnormal
// below 1e-38, and the velocities of bodies that come to rest become so small.
//
// The other settings of the thread's floating-point environment, as traps and rounding, stay. On processors other than x86 it does nothing.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>

class dxFlushSubnormals {
public:
    dxFlushSubnormals() : m_before(_mm_getcsr()) { _mm_setcsr(m_before | kFlushResults | kFlushOperands); }
    ~dxFlushSubnormals() { _mm_setcsr((_mm_getcsr() & ~(kFlushResults | kFlushOperands)) | (m_before & (kFlushResults | kFlushOperands))); }
    dxFlushSubnormals(const dxFlushSubnormals &) = delete;
    dxFlushSubnormals &operator=(const dxFlushSubnormals &) = delete;

private:
    static constexpr unsigned kFlushResults = 1u << 15, kFlushOperands = 1u << 6;  // of MXCSR

    const unsigned m_before;
};

#else

class dxFlushSubnormals {
public:
    dxFlushSubnormals() {}
    ~dxFlushSubnormals() {}
    dxFlushSubnormals(const dxFlushSubnormals &) = delete;
    dxFlushSubnormals &operator=(const dxFlushSubnormals &) = delete;
};

#endif
