#include "dynamics/step/dxIslandPreparation.h"

#include <algorithm>
#include <optional>

#include "dynamics/step/dxIslandBlocks.h"
#include "dynamics/step/dxIslandStepper.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxUpstreamScope.h"

namespace {

// Islands cheaper than this share a block, so that taking a block costs little beside its work.
constexpr double kMinBlockNs = 3e3;

// More blocks than workers even out what the cost model misjudges.
constexpr unsigned kBlocksPerWorker = 8;

void resetRecords(const dxStepCall &call, unsigned workers, dxStepRecords &records) {
    records.islands.resize(call.count);
    dxIslandCursor cursor(call.info);
    for (dxIslandRecord &record : records.islands) {
        record = {};
        record.island = cursor.next();
        record.cost = dxCostModel::islandCost(call.kind, call.world->qs.num_iterations, record.island.bodyCount,
                                              record.island.jointCount);
    }
    if (records.workers.size() < workers) records.workers.resize(workers);
    for (dxWorkerRecord &worker : records.workers) worker.reset();
    records.run.begin(call.count, workers, dxHasUserHandlers());
}

// On a worker.
void survey(const dxStepCall &call, dxStepRecords &records, unsigned begin, unsigned end, unsigned worker) {
    for (unsigned i = begin; i < end; ++i) {
        dxIslandRecord &record = records.islands[i];
        record.inOrder = dxHasMovedCallback(record.island);
        if (dxIslandStepper::drawsRandomNumbers(call)) {
            const std::optional<unsigned> rows = dxCountRows(record.island);
            record.rows = rows.value_or(0);
            record.inOrder = record.inOrder || !rows;
        }
        records.run.collectFeedback(record.island, i, worker);
    }
}

}  // namespace

void dxPrepareIslands(const dxStepCall &call, unsigned workers, dxStepRecords &records) {
    resetRecords(call, workers, records);
    const unsigned chunks = std::min(call.count, workers * kBlocksPerWorker);
    dxWorkersRunner(workers, call.world)
        .forBlocks(dxParallelStage::IslandSurvey, chunks, [&call, &records, chunks](unsigned chunk, unsigned worker) {
            const std::uint64_t count = call.count;
            survey(call, records, chunk * count / chunks, (chunk + 1) * count / chunks, worker);
        });
    // Two joints may have been given one feedback structure, or two that overlap: upstream's later island overwrites it.
    records.run.forSharedFeedback([&records](unsigned island) { records.islands[island].inOrder = true; });
    const auto first = std::find_if(records.islands.begin(), records.islands.end(),
                                    [](const dxIslandRecord &record) { return record.inOrder; });
    records.inOrderFrom = static_cast<unsigned>(first - records.islands.begin());
    double cost = 0;
    for (unsigned i = 0; i < records.inOrderFrom; ++i) cost += records.islands[i].cost;
    dxCutIslandBlocks(records, records.inOrderFrom, std::max(kMinBlockNs, cost / (kBlocksPerWorker * workers)));
}

void dxReserveRandomNumbers(const dxStepCall &call, dxStepRecords &records) {
    if (!dxIslandStepper::drawsRandomNumbers(call)) return;
    records.run.reserve(records.inOrderFrom, [&](unsigned island) { return dxIslandStepper::drawsOf(call, records.islands[island].rows); });
}
