#include "dynamics/step/dxIslandBlocks.h"

#include <algorithm>

void dxCutIslandBlocks(dxStepRecords &records, unsigned end, double least) {
    const std::vector<dxIslandRecord> &islands = records.islands;
    records.order.clear();
    records.blocks.clear();

    for (unsigned i = 0; i < end; ++i) {
        if (islands[i].cost >= least) records.order.push_back(i);
    }
    std::sort(records.order.begin(), records.order.end(), [&islands](unsigned a, unsigned b) {
        return islands[a].cost != islands[b].cost ? islands[a].cost > islands[b].cost : a < b;
    });
    const unsigned large = static_cast<unsigned>(records.order.size());
    for (unsigned i = 0; i < large; ++i) records.blocks.push_back({i, i + 1});

    // Small islands stay in their own order: neighbours in it are often neighbours in memory.
    double cost = 0;
    unsigned begin = large;
    for (unsigned i = 0; i < end; ++i) {
        if (islands[i].cost >= least) continue;
        records.order.push_back(i);
        cost += islands[i].cost;
        if (cost >= least) {
            records.blocks.push_back({begin, static_cast<unsigned>(records.order.size())});
            begin = records.blocks.back().end;
            cost = 0;
        }
    }
    if (begin < records.order.size()) records.blocks.push_back({begin, static_cast<unsigned>(records.order.size())});
}
