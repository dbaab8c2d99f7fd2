#include "dynamics/quick_step/sor/dxParallelSor.h"

#include <algorithm>
#include <limits>
#include <thread>
#include <utility>

#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxSpin.h"
#include "threading/process/dxProcess.h"

namespace {

constexpr std::uint16_t kActsOnBoundary = 1 << 15;

// Number of polls of another part's progress before a thread tries another part, and number of such rounds before it
// yields.
constexpr int kSpinPolls = 256;
constexpr int kRounds = 16;

dxProcessObject<dxObjectPool<dxParallelSor>> idle;

std::size_t bodyOf(const dxIslandProblem &problem, std::size_t row, unsigned which) {
    return static_cast<std::size_t>(problem.rows[row].body[which]);
}

}  // namespace

// A row that acts on a boundary body, in the order of the sweep.
struct dxParallelSor::BoundaryRow {
    unsigned row;
    std::uint32_t part;
    std::int32_t position;  // in its part
};

struct alignas(128) dxParallelSor::Part {
    // How many rows of another part must be done before the row at `at`. Counted from the beginning of the sweep: zero
    // and below were done in the sweep before.
    struct Wait {
        std::uint32_t at;
        std::uint32_t part;
        std::int32_t rows;
    };
    // The last row that acts on a body.
    struct Last {
        std::uint32_t part;
        std::int32_t position;
    };

    std::atomic<std::int64_t> done{0};   // rows, of all sweeps
    alignas(128) std::atomic<bool> isTaken{false};
    std::atomic<bool> isFinished{false};

    // Where it is. Of the thread that has taken the part.
    std::size_t row, wait;
    unsigned sweep;

    std::vector<std::uint32_t> rows;     // dxSorRun's
    std::vector<Wait> waits;
    // While planning:
    std::vector<BoundaryRow> boundaryRows;
    std::vector<Last> last;              // by body, of shared ones
    std::vector<std::uint32_t> counts;   // rows, by part
    std::vector<std::int32_t> requested, announced;

    std::int64_t length() const { return static_cast<std::int64_t>(rows.size()); }
};

dxObjectPool<dxParallelSor> &dxParallelSor::pool() { return *idle; }

dxParallelSor::dxParallelSor() = default;
dxParallelSor::~dxParallelSor() = default;

void dxParallelSor::partition(const dxIslandProblem &problem, unsigned parts) {
    m_partCount = parts;
    while (m_parts.size() < parts) m_parts.push_back(std::make_unique<Part>());
    m_weights.assign(problem.bodyCount, 0);
    for (std::size_t row = 0; row < problem.rowCount; ++row) ++m_weights[bodyOf(problem, row, 0)];
    m_partition.partition(m_places, m_weights, parts);
    markBoundaryBodies(problem);
}

void dxParallelSor::markBoundaryBodies(const dxIslandProblem &problem) {
    m_isBoundary.assign(problem.bodyCount, 0);
    m_boundaryBodies.clear();
    for (std::size_t row = 0; row < problem.rowCount; ++row) {
        if (!problem.rows[row].hasSecondBody()) continue;
        const std::size_t second = bodyOf(problem, row, 1);
        if (m_isBoundary[second] || m_partition.partitionOf(bodyOf(problem, row, 0)) == m_partition.partitionOf(second)) continue;
        m_isBoundary[second] = 1;
        m_boundaryBodies.push_back(static_cast<unsigned>(second));
    }
    m_partOfRow.resize(problem.rowCount);
    for (std::size_t row = 0; row < problem.rowCount; ++row) {
        const std::size_t first = bodyOf(problem, row, 0);
        const bool isBoundary = m_isBoundary[first] || (problem.rows[row].hasSecondBody() && m_isBoundary[bodyOf(problem, row, 1)]);
        m_partOfRow[row] = static_cast<std::uint16_t>(m_partition.partitionOf(first) | (isBoundary ? kActsOnBoundary : 0));
    }
}

void dxParallelSor::sweep(const dxIslandProblem &problem, const int *order, unsigned times, dxTaskRunner &runner) {
    runner.forBlocks(dxParallelStage::SorPlan, m_partCount, [&](unsigned number, unsigned) { plan(problem, order, number); });
    runner.forBlocks(dxParallelStage::SorSweep, m_partCount, [&](unsigned number, unsigned) { finish(problem, number, times); });
}

void dxParallelSor::plan(const dxIslandProblem &problem, const int *order, unsigned number) {
    Part &part = *m_parts[number];
    distribute(problem, order, number);
    orderBoundaryRows(problem, number);
    part.row = part.wait = 0;
    part.sweep = 0;
    part.done.store(0, std::memory_order_relaxed);
    part.isFinished.store(part.rows.empty(), std::memory_order_relaxed);
}

void dxParallelSor::distribute(const dxIslandProblem &problem, const int *order, unsigned number) {
    Part &part = *m_parts[number];
    part.rows.clear();
    part.boundaryRows.clear();
    part.counts.assign(m_partCount, 0);
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        const auto row = static_cast<unsigned>(order[i]);
        const std::uint16_t tag = m_partOfRow[row];
        const std::uint32_t owner = tag & ~kActsOnBoundary;
        const std::uint32_t position = part.counts[owner]++;
        if (owner == number) part.rows.push_back(row);
        if (tag & kActsOnBoundary) part.boundaryRows.push_back({row, owner, static_cast<std::int32_t>(position)});
    }
}

// All parts find the same pairs of rows that follow one another on a body, each by itself. Of a pair in
// different parts the later row waits for the earlier one, unless it waits for a still later row of that part anyway.
void dxParallelSor::orderBoundaryRows(const dxIslandProblem &problem, unsigned number) {
    Part &part = *m_parts[number];
    part.waits.clear();
    part.last.resize(problem.bodyCount);
    part.requested.assign(m_partCount, std::numeric_limits<std::int32_t>::min());
    part.announced.assign(m_partCount, std::numeric_limits<std::int32_t>::min());
    const auto forBoundaryBodies = [&](const BoundaryRow &boundary, auto &&visit) {
        for (const int body : problem.rows[boundary.row].body)
            if (body != dxConstraintRow::kNone && m_isBoundary[static_cast<std::size_t>(body)])
                visit(part.last[static_cast<std::size_t>(body)]);
    };
    // Before the first row on a body comes the last one of the sweep before.
    for (const BoundaryRow &boundary : part.boundaryRows)
        forBoundaryBodies(boundary, [&](Part::Last &last) { last = {boundary.part, boundary.position}; });
    for (const unsigned body : m_boundaryBodies)
        part.last[body].position -= static_cast<std::int32_t>(part.counts[part.last[body].part]);
    for (const BoundaryRow &boundary : part.boundaryRows)
        forBoundaryBodies(boundary, [&](Part::Last &last) {
            const Part::Last before = std::exchange(last, {boundary.part, boundary.position});
            const std::int32_t rows = before.position + 1;
            if (before.part == boundary.part) return;
            if (boundary.part == number && rows > part.requested[before.part]) {
                part.requested[before.part] = rows;
                part.waits.push_back({static_cast<std::uint32_t>(boundary.position), before.part, rows});
                part.rows[static_cast<std::size_t>(boundary.position)] |= dxSorRun::kWaits;
            } else if (before.part == number && rows > part.announced[boundary.part]) {
                part.announced[boundary.part] = rows;
                const std::int64_t at = before.position < 0 ? before.position + part.length() : before.position;
                part.rows[static_cast<std::size_t>(at)] |= dxSorRun::kAnnounces;
            }
        });
}

// Returns when the part is finished, by this thread or another one.
void dxParallelSor::finish(const dxIslandProblem &problem, unsigned number, unsigned times) {
    const auto tryPart = [&](unsigned which) {
        Part &part = *m_parts[which];
        dxPerturb(dxSchedulePoint::ClaimPartition);
        if (part.isFinished.load(std::memory_order_relaxed) || part.isTaken.exchange(true, std::memory_order_acquire)) return;
        if (!part.isFinished.load(std::memory_order_relaxed)) advance(problem, part, times);
        part.isTaken.store(false, std::memory_order_release);
    };
    for (int round = 1; !m_parts[number]->isFinished.load(std::memory_order_acquire); ++round) {
        tryPart(number);
        if (m_parts[number]->isFinished.load(std::memory_order_acquire)) return;
        for (unsigned i = 1; i < m_partCount; ++i) tryPart((number + i) % m_partCount);
        if (round % kRounds == 0) std::this_thread::yield();
    }
}

// Advances a part until it must wait.
void dxParallelSor::advance(const dxIslandProblem &problem, Part &part, unsigned times) {
    while (mayProceed(part)) {
        part.row = dxRelaxRun(problem, part.rows.data(), part.row, part.rows.size());
        dxPerturb(dxSchedulePoint::AnnounceRows);
        part.done.store(part.sweep * part.length() + static_cast<std::int64_t>(part.row), std::memory_order_release);
        if (part.row < part.rows.size()) continue;
        part.row = part.wait = 0;
        if (++part.sweep == times) {
            part.isFinished.store(true, std::memory_order_release);
            return;
        }
    }
}

bool dxParallelSor::mayProceed(Part &part) {
    for (; part.wait < part.waits.size() && part.waits[part.wait].at == part.row; ++part.wait) {
        const Part::Wait &wait = part.waits[part.wait];
        const Part &other = *m_parts[wait.part];
        const std::int64_t needed = part.sweep * other.length() + wait.rows;
        int polls = kSpinPolls;
        while (other.done.load(std::memory_order_acquire) < needed) {
            if (polls == kSpinPolls) dxPerturb(dxSchedulePoint::AwaitRows);
            if (--polls == 0) return false;
            dxPause();
        }
    }
    return true;
}
