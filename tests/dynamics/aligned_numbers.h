// Numbers that begin at a cache line.
#pragma once

#include "core/dxCacheLine.h"

#include <cstddef>
#include <new>
#include <vector>

template <class Number>
struct LineAllocator {
    using value_type = Number;

    LineAllocator() = default;
    template <class Other>
    LineAllocator(const LineAllocator<Other> &) {}

    Number *allocate(std::size_t count) {
        return static_cast<Number *>(::operator new(count * sizeof(Number), std::align_val_t(kCacheLine)));
    }
    void deallocate(Number *numbers, std::size_t) { ::operator delete(numbers, std::align_val_t(kCacheLine)); }

    template <class Other>
    bool operator==(const LineAllocator<Other> &) const { return true; }
    template <class Other>
    bool operator!=(const LineAllocator<Other> &) const { return false; }
};

using AlignedNumbers = std::vector<dReal, LineAllocator<dReal>>;
