#include "settings/dxStageTimeline.h"

#include <array>
#include <atomic>
#include <cstddef>

#include "settings/dxWorkersRunner.h"

namespace {

// A stage as its caller sees it, and as a worker does.
struct Events {
    dxTimelineEvent run, blocks;
};

// Other stages are parts of these.
constexpr dxFrameStage frameStageOf(dxParallelStage stage) {
    switch (stage) {
        case dxParallelStage::Islands: return dxFrameStage::Islands;
        case dxParallelStage::NarrowphasePrefetch: return dxFrameStage::NarrowphasePrefetch;
        case dxParallelStage::Callbacks: return dxFrameStage::NearCallbacks;
        default: return dxFrameStage::None;
    }
}

constexpr std::array<Events, dxParallelStages::kCount> eventsOfStages() {
    std::array<Events, dxParallelStages::kCount> events{};
    for (std::size_t i = 0; i < events.size(); ++i)
        events[i] = {{dxParallelStages::kNames[i], "stage", {"blocks", "run", "workers"}, dxTimelineEvent::Kind::Span,
                      frameStageOf(static_cast<dxParallelStage>(i))},
                     {dxParallelStages::kNames[i], "worker", {"blocks", "run"}}};
    return events;
}

constexpr std::array<Events, dxParallelStages::kCount> kEvents = eventsOfStages();
constexpr dxTimelineEvent kWait{"wait for workers", "wait", {"run"}, dxTimelineEvent::Kind::Span, dxFrameStage::Wait};
constexpr std::uint64_t kMinWait = 1000;  // ticks: less than a microsecond

std::atomic<std::uint64_t> runs{0};

const Events &eventsOf(dxParallelStage stage) { return kEvents[static_cast<std::size_t>(stage)]; }

}  // namespace

dxStageTimeline::dxStageTimeline(const dxWorkersRunner &runner, dxParallelStage stage, unsigned blocks)
    : m_runner(runner), m_stage(stage), m_blocks(blocks), m_ring(dxTimeline::ofThisThread()) {
    if (m_ring == nullptr) return;
    m_caller = m_ring->caller();
    m_run = runs.fetch_add(1, std::memory_order_relaxed) + 1;
    m_begin = m_callerEnds = dxTimelineClock::ticks();
}

void dxStageTimeline::end() {
    const std::uint64_t now = dxTimelineClock::ticks();
    const unsigned workers = m_runner.tookPart();
    m_ring->noteThreads(workers);
    if (now - m_callerEnds >= kMinWait) m_ring->add(kWait, m_callerEnds, now, {m_run});
    m_ring->add(eventsOf(m_stage).run, m_begin, now, {m_blocks, m_run, workers});
}

void dxStageTimeline::Block::begin() {
    m_ring = m_isOfCaller ? m_timeline.m_ring : dxTimeline::ofThisThread();
    if (m_isOfCaller || m_ring == nullptr) return;
    m_before = m_ring->caller();
    m_ring->setCaller(m_timeline.m_caller);
    m_begin = m_ring->beginBlock(eventsOf(m_timeline.m_stage).blocks, m_timeline.m_run);
}

void dxStageTimeline::Block::end() {
    if (m_isOfCaller) {
        m_timeline.m_callerEnds = dxTimelineClock::ticks();
        return;
    }
    m_ring->endBlock(eventsOf(m_timeline.m_stage).blocks, m_timeline.m_run, m_begin);
    m_ring->setCaller(m_before);
}
