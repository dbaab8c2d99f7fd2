#include "dynamics/step/dxIslandPreparation.h"

#include <algorithm>
#include <optional>

#include "dynamics/step/dxIslandStepper.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxUpstreamScope.h"

namespace {

// Islands cheaper than this share a block, so that taking a block costs little beside its work. Units: ns.
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

void dxCutIslandBlocks(dxStepRecords &records, unsigned end, double minCost) {
    const std::vector<dxIslandRecord> &islands = records.islands;
    records.order.clear();
    records.blocks.clear();

    for (unsigned i = 0; i < end; ++i) {
        if (islands[i].cost >= minCost) records.order.push_back(i);
    }
    std::sort(records.order.begin(), records.order.end(), [&islands](unsigned a, unsigned b) {
        return islands[a].cost != islands[b].cost ? islands[a].cost > islands[b].cost : a < b;
    });
    const unsigned large = static_cast<unsigned>(records.order.size());
    for (unsigned i = 0; i < large; ++i) records.blocks.push_back({i, i + 1});

    // Small islands keep their order: neighbours in it are often neighbours in memory.
    double cost = 0;
    unsigned begin = large;
    for (unsigned i = 0; i < end; ++i) {
        if (islands[i].cost >= minCost) continue;
        records.order.push_back(i);
        cost += islands[i].cost;
        if (cost >= minCost) {
            records.blocks.push_back({begin, static_cast<unsigned>(records.order.size())});
            begin = records.blocks.back().end;
            cost = 0;
        }
    }
    if (begin < records.order.size()) records.blocks.push_back({begin, static_cast<unsigned>(records.order.size())});
}
