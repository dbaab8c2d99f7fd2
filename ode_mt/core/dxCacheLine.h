// The size of a cache line, and the number of elements in one: the lanes of wide loops, for any vector length.
#pragma once

#include <ode/common.h>

#include <cstddef>

constexpr unsigned kCacheLine = 64;  // bytes
constexpr unsigned kLineLanes = kCacheLine / sizeof(dReal);
constexpr unsigned kHalfLine = kLineLanes / 2;
