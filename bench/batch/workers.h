// Worker processes of one machine: each runs one world at a time, on one thread, and answers with a line of JSON (runWorld).
//
// Processes, since the random sequence and the end by an error are a process's in ODE. They are forked before anything else starts threads (or
// MPI), and end with their parent. A world that ends its worker by an error of its own (abort, SIGSEGV …) costs its run, which gets the
// status "error"; a worker that was killed (SIGKILL, SIGTERM) is replaced, and its run goes to another.
//
// Threading: one thread.
#pragma once

#include "batch/plan.h"

#include <sys/types.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace batch {

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
        int commands = -1, answers = -1;  // files
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

}  // namespace batch
