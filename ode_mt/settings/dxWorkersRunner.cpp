#include "settings/dxWorkersRunner.h"

#include <algorithm>

#include "settings/dxStageTimeline.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorldWorkers.h"

void dxWorkersRunner::run(dxParallelStage stage, unsigned blocks, dxThreadManager::Task task, void *context) {
    dxStageTimeline timeline(*this, stage, blocks);
    struct Job {
        dxThreadManager::Task task;
        void *context;
        bool *ranABlock;
        dxStageWatch watch;
        dxStageTimeline &timeline;
    } job{task, context, m_ranABlock, dxStageWatch(stage), timeline};
    const auto watched = [](void *of, unsigned block, unsigned worker) {
        Job &running = *static_cast<Job *>(of);
        running.watch.see(worker);
        const dxStageTimeline::Block recorded(running.timeline, worker);
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
