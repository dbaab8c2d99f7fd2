// The scope of work that a worker does ahead for a call: whatever upstream's code would report, or would draw from the random
// sequence, interrupts it, and the call does the work again in its turn, on its own thread.
#pragma once

#include "threading/dxUpstreamInterrupted.h"
#include "threading/dxUpstreamScope.h"

class dxInterruptingScope final : public dxUpstreamScope {
public:
    std::uint32_t takeBlock(std::uint64_t) override { throw dxUpstreamInterrupted(); }
    bool defersMoved() const override { return false; }
    bool takeOver(dxReport, int, const char *, va_list) override { throw dxUpstreamInterrupted(); }
};
