// Processes that make worlds for this one: workers, which run them, and the check of a plan's worlds before any is run.
#pragma once

#include <sys/types.h>

#include <deque>
#include <string>
#include <vector>

#include "batch/plan.h"
#include "support/process.h"

namespace batch {

// Worker processes of one machine: each runs one world at a time, on one thread, and answers with a line of JSON (runWorld).
//
// Processes, since the random sequence and the end by an error are a process's in ODE. They are forked before anything else starts threads (or
// MPI), and end with their parent. A world that ends its worker by an error of its own (abort, SIGSEGV …) costs its run, which gets the
// status "error"; a worker that was killed (SIGKILL, SIGTERM) is replaced, and its run goes to another.
//
// Threading: one thread.
class Workers {
public:
    // Throws std::runtime_error where the system refuses a process.
    Workers(const Plan &plan, unsigned count);
    ~Workers();
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    unsigned count() const { return static_cast<unsigned>(m_workers.size()); }
    std::size_t outstanding() const;  // runs that were given and not answered

    void give(const std::vector<long> &runs);

    // Waits until there are answers, or for so long. Returns them.
    std::vector<Json> takeAnswers(int milliseconds);

private:
    struct Worker {
        pid_t process = -1;
        support::Descriptor commands, answers;
        std::deque<long> runs;            // that it has; the first one is in progress
        std::string text;                 // of an answer that is not complete
        unsigned kills = 0;               // while the first one was in progress
    };

    void start(Worker &worker);
    void feed();
    void read(unsigned index, std::vector<Json> &answers);
    void replace(unsigned index, std::vector<Json> &answers);

    const Plan &m_plan;
    std::vector<Worker> m_workers;
    std::deque<long> m_queue;
};

// Whether the worlds of a plan have what it names, before its first run: bodies, joints, sensors, elements of SDF files.
//
// Makes the world of the first run of each world of the plan. Throws std::runtime_error with what one of them has not. A world that ends
// its process, and what only other values of parameters bring about, is left to the run, which gets the status "error" for it.
//
// A process of its own makes them, which is left as it is by ODE's errors, random numbers and memory. Requires that no threads are running.
void checkWorlds(const Plan &plan);

}  // namespace batch
