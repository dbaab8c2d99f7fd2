// The scope of an island that a worker steps on behalf of the thread that called the step.
//
//   random draws   come from the island's own part of the sequence
//   moved          notifications are deferred; dxIslandParallelStep replays them in upstream's order
//   dMessage       is kept; dxIslandParallelStep delivers it in island order on the calling thread
//   dDebug, dError end the island. So does dMessage where the user has installed a handler: it may look
//                  at the world, or never return, so the island is stepped again in order, for the user
//                  to see the world as upstream shows it
#pragma once

#include <string>
#include <vector>

#include "threading/dxUpstreamInterrupted.h"
#include "threading/dxUpstreamScope.h"

struct dxKeptReport {
    unsigned island;
    dxReport kind;
    int number;
    std::string text;

    void deliver() const;  // calls dMessage, dDebug or dError
};

class dxDeferredIsland final : public dxUpstreamScope {
public:
    dxDeferredIsland(unsigned island, std::uint32_t seed, bool userHandlers, std::vector<dxKeptReport> &reports)
        : m_island(island), m_seed(seed), m_userHandlers(userHandlers), m_reports(reports) {}

    std::uint32_t takeBlock(std::uint64_t draws) override;
    bool defersMoved() const override { return true; }
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override;

private:
    unsigned m_island;
    std::uint32_t m_seed;
    bool m_userHandlers;
    std::vector<dxKeptReport> &m_reports;
};
