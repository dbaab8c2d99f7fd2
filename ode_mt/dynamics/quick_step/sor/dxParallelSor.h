// Parallel SOR: QuickStep's sweeps over one large island on several threads, with the bits of one.
//
// The bodies are partitioned (dxBodyPartition); a row belongs to the part of its first body. Each part takes its rows in the
// order of the serial sweep. Rows of different parts that act on the same boundary body must keep their order: such a
// row waits until the part of the row before it has finished that row. Most rows act only on bodies of their own part
// and never wait. A part may start the next sweep while others are still in this one. docs/exact.md has the proof and a
// picture.
//
// A thread that cannot proceed with a part releases it and tries another one, so any number of threads, one included,
// finishes all parts.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "dynamics/quick_step/sor/dxBodyPartition.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"
#include "threading/dxTaskRunner.h"
#include "threading/process/dxObjectPool.h"

class dxParallelSor {
public:
    dxParallelSor();
    ~dxParallelSor();

    // One that no step is using, or a new one: its memory is kept from step to step. Throws std::bad_alloc.
    using Lease = dxPooledObject<dxParallelSor>;
    static dxObjectPool<dxParallelSor> &pool();

    // Minimum number of rows of a part: below, waiting costs more than parallelism gains.
    static constexpr unsigned kMinRows = 500;

    // Partitions the island. `placeOf(body)` returns the position, three numbers.
    template <class PlaceOf>
    void begin(const dxIslandProblem &problem, unsigned parts, PlaceOf placeOf) {
        m_places.resize(problem.bodyCount);
        for (std::size_t body = 0; body < problem.bodyCount; ++body) {
            const dReal *const at = placeOf(body);
            m_places[body] = {{at[0], at[1], at[2]}};
        }
        partition(problem, parts);
    }

    // Computes what `times` calls of dxSorSweep(problem, order, isLarge) compute.
    void sweep(const dxIslandProblem &problem, const int *order, unsigned times, dxTaskRunner &runner);

private:
    struct Part;
    struct BoundaryRow;

    void partition(const dxIslandProblem &problem, unsigned parts);
    void markBoundaryBodies(const dxIslandProblem &problem);
    void plan(const dxIslandProblem &problem, const int *order, unsigned number);
    void distribute(const dxIslandProblem &problem, const int *order, unsigned number);
    void orderBoundaryRows(const dxIslandProblem &problem, unsigned number);
    void finish(const dxIslandProblem &problem, unsigned number, unsigned times);
    void advance(const dxIslandProblem &problem, Part &part, unsigned times);
    bool mayProceed(Part &part);

    std::vector<dxPlace> m_places;                // by body
    dxBodyPartition m_partition;
    std::vector<unsigned> m_weights;              // by body: rows that act on it
    std::vector<std::uint8_t> m_isBoundary;         // by body: rows of several parts act on it
    std::vector<unsigned> m_boundaryBodies;
    std::vector<std::uint16_t> m_partOfRow;       // and whether it acts on a boundary body
    std::vector<std::unique_ptr<Part>> m_parts;
    unsigned m_partCount = 0;
};
