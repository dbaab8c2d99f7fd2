// A line of the cache, and the rows or columns that lie in one side by side: the lanes of wide loops, however
// many of them a vector has.
#pragma once

#include <ode/common.h>

#include <cstddef>

constexpr unsigned kCacheLine = 64;  // bytes
constexpr unsigned kLineLanes = kCacheLine / sizeof(dReal);
constexpr unsigned kHalfLine = kLineLanes / 2;
