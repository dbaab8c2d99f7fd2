#include "settings/dxWorkersRunner.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "settings/dxLentThreads.h"
#include "settings/dxWorkers.h"
#include "threading/dxParallelStage.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// A run of a stage on the caller, and on a worker.
struct Events {
    dxTimelineEvent run, blocks;
};

// Returns the stage of a frame; other stages are parts of these.
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

// One run of a parallel stage on the timeline: an event of the caller for the run, one of each worker for the blocks that it has run one
// after the other, and one for the time that the caller has waited for them. While nothing is recorded a run costs one load, and a block one
// comparison.
class StageTimeline {
public:
    StageTimeline(const dxWorkersRunner &runner, dxParallelStage stage, unsigned blocks);
    ~StageTimeline() {
        if (m_ring != nullptr) end();
    }
    StageTimeline(const StageTimeline &) = delete;
    StageTimeline &operator=(const StageTimeline &) = delete;

    // A block, on the thread that runs it.
    class Block {
    public:
        Block(StageTimeline &timeline, unsigned worker) : m_timeline(timeline), m_isOfCaller(worker == 0) {
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

        StageTimeline &m_timeline;
        const bool m_isOfCaller;
        dxTimelineRing *m_ring = nullptr;  // of this thread
        dxTimelineRing::Caller m_before{};
        std::uint64_t m_begin = 0;
    };

private:
    void end();
    void count(std::uint64_t now);

    const dxWorkersRunner &m_runner;
    const dxParallelStage m_stage;
    const unsigned m_blocks;
    dxTimelineRing *const m_ring;  // the caller's; null: nothing is recorded
    dxTimelineRing::Caller m_caller{};
    std::uint64_t m_run = 0, m_begin = 0;
    std::uint64_t m_callerEnds = 0;  // end of its last block so far; written by the caller alone
    std::uint64_t m_sharedBefore = 0, m_workBefore = 0;  // of the frame
    std::atomic<std::uint64_t> m_workOfOthers{0};        // ticks
};

StageTimeline::StageTimeline(const dxWorkersRunner &runner, dxParallelStage stage, unsigned blocks)
    : m_runner(runner), m_stage(stage), m_blocks(blocks), m_ring(dxTimeline::ofThisThread()) {
    if (m_ring == nullptr) return;
    m_caller = m_ring->caller();
    m_run = runs.fetch_add(1, std::memory_order_relaxed) + 1;
    m_sharedBefore = m_ring->times()[dxFrameStage::Shared];
    m_workBefore = m_ring->times()[dxFrameStage::Work];
    m_begin = m_callerEnds = dxTimelineClock::ticks();
}

void StageTimeline::end() {
    const std::uint64_t now = dxTimelineClock::ticks();
    const unsigned workers = m_runner.tookPart();
    m_ring->noteThreads(workers);
    if (now - m_callerEnds >= kMinWait) m_ring->add(kWait, m_callerEnds, now, {m_run});
    m_ring->add(eventsOf(m_stage).run, m_begin, now, {m_blocks, m_run, workers});
    if (m_runner.workers() > 1 && m_blocks > 1) count(now);
}

// Runs within this one, which its blocks have made, are a part of it.
void StageTimeline::count(std::uint64_t now) {
    m_ring->setTime(dxFrameStage::Shared, m_sharedBefore + (now - m_begin));
    m_ring->setTime(dxFrameStage::Work, m_workBefore + (m_callerEnds - m_begin) + m_workOfOthers.load(std::memory_order_relaxed));
}

void StageTimeline::Block::begin() {
    m_ring = m_isOfCaller ? m_timeline.m_ring : dxTimeline::ofThisThread();
    if (m_isOfCaller || m_ring == nullptr) return;
    m_before = m_ring->caller();
    m_ring->setCaller(m_timeline.m_caller);
    m_begin = m_ring->beginBlock(eventsOf(m_timeline.m_stage).blocks, m_timeline.m_run);
}

void StageTimeline::Block::end() {
    if (m_isOfCaller) {
        m_timeline.m_callerEnds = dxTimelineClock::ticks();
        return;
    }
    const std::uint64_t end = m_ring->endBlock(eventsOf(m_timeline.m_stage).blocks, m_timeline.m_run, m_begin);
    m_timeline.m_workOfOthers.fetch_add(end - m_begin, std::memory_order_relaxed);
    m_ring->setCaller(m_before);
}

}  // namespace

void dxWorkersRunner::run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) {
    StageTimeline timeline(*this, stage, blocks);
    struct Job {
        dxThreadManager::Task task;
        void *context;
        bool *ranABlock;
        dxStageWatch watch;
        StageTimeline &timeline;
    } job{task, context, m_ranABlock, dxStageWatch(stage), timeline};
    const auto watched = [](void *of, unsigned block, unsigned worker) {
        Job &running = *static_cast<Job *>(of);
        running.watch.see(worker);
        const StageTimeline::Block recorded(running.timeline, worker);
        running.task(running.context, block, worker);
        if (!running.ranABlock[worker]) running.ranABlock[worker] = true;  // bytes of other workers are beside it
    };
    if (m_world != nullptr && dxWorldWorkers::given(m_world))
        dxWorldWorkers::run(m_world, blocks, m_workers, watched, &job);
    else
        dxWorkers::instance().run(blocks, m_workers, watched, &job);
}

unsigned dxWorkersRunner::tookPart() const {
    return static_cast<unsigned>(std::count(m_ranABlock, m_ranABlock + m_workers, true));
}
