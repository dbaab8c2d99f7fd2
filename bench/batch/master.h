// Hands out the runs of a plan and writes their rows, and shows how far they are.
//
// Whoever has workers is a site: this process, and other ranks. A site is given runs for the next tenth of a second, so that its workers
// never wait for the master, and fewer towards the end, so that all end at about the same time. Which site runs what changes no row.
//
// Threading: one thread.
#pragma once

#include <utility>
#include <vector>

#include "batch/store.h"
#include "batch/workers.h"

namespace batch {

// Sites elsewhere (MPI).
class Ranks {
public:
    virtual ~Ranks() = default;
    virtual unsigned count() const = 0;
    virtual unsigned workers(unsigned index) const = 0;
    virtual void give(unsigned index, const std::vector<long> &runs) = 0;
    virtual std::vector<std::pair<unsigned, Json>> takeAnswers() = 0;  // of which index; does not wait
};

// Runs what the store has not. `ranks`: null if there are none. `isQuiet`: no line on standard error says how far it is. Throws
// std::runtime_error.
void runPlan(const Plan &plan, Store &store, Workers &workers, Ranks *ranks, bool isQuiet);

// What the program ends with: 1 if runs in the table have failed, by this call or one before, which is said on standard error.
int exitCodeOf(const Store &store);

}  // namespace batch
