// One run of a parallel stage on the timeline: an event of the caller for the run, one of each worker for the blocks that it has run one
// after the other, and one for the time that the caller has waited for them.
//
// While nothing is recorded a run costs one load, and a block a look at what was loaded.
#pragma once

#include <cstdint>

#include "threading/dxParallelStage.h"
#include "threading/timeline/dxTimeline.h"

class dxWorkersRunner;

class dxStageTimeline {
public:
    dxStageTimeline(const dxWorkersRunner &runner, dxParallelStage stage, unsigned blocks);
    ~dxStageTimeline() {
        if (m_ring != nullptr) end();
    }
    dxStageTimeline(const dxStageTimeline &) = delete;
    dxStageTimeline &operator=(const dxStageTimeline &) = delete;

    // A block, on the thread that runs it.
    class Block {
    public:
        Block(dxStageTimeline &timeline, unsigned worker) : m_timeline(timeline), m_isOfCaller(worker == 0) {
            if (timeline.m_ring != nullptr) begin();
        }
        ~Block() {
            if (m_ring != nullptr) end();
        }
        Block(const Block &) = delete;
        Block &operator=(const Block &) = delete;

    private:
        void begin();
        void end();

        dxStageTimeline &m_timeline;
        const bool m_isOfCaller;
        dxTimelineRing *m_ring = nullptr;  // of this thread
        dxTimelineRing::Caller m_before{};
        std::uint64_t m_begin = 0;
    };

private:
    void end();

    const dxWorkersRunner &m_runner;
    const dxParallelStage m_stage;
    const unsigned m_blocks;
    dxTimelineRing *const m_ring;  // the caller's; null: nothing is recorded
    dxTimelineRing::Caller m_caller{};
    std::uint64_t m_run = 0, m_begin = 0;
    std::uint64_t m_callerEnds = 0;  // its last block so far; written by it alone
};
