// The number of a problem: that of its batch above, its index among the batch's problems below.
#pragma once

#include <cstdint>

constexpr unsigned kRemoteIndexBits = 32;

constexpr std::uint64_t dxRemoteNumber(std::uint64_t batch, unsigned index) { return batch << kRemoteIndexBits | index; }
constexpr std::uint64_t dxRemoteBatchOf(std::uint64_t number) { return number >> kRemoteIndexBits; }
constexpr unsigned dxRemoteIndexOf(std::uint64_t number) { return static_cast<unsigned>(number & ((std::uint64_t{1} << kRemoteIndexBits) - 1)); }
