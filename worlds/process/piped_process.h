// A process that is spoken to: its standard input and output are pipes of ours.
#pragma once

#include "process/spawn.h"

namespace process {

class PipedProcess {
public:
    // `errors`: its standard error, -1: this process's. Throws std::runtime_error if it cannot be started.
    PipedProcess(const std::vector<std::string> &command, const Environment &changes, int errors = -1);
    ~PipedProcess();  // closes the pipes, and kills it if it has not been waited for
    PipedProcess(const PipedProcess &) = delete;
    PipedProcess &operator=(const PipedProcess &) = delete;

    int input() const { return m_input; }  // to be written to
    int output() const { return m_output; }
    void closeInput();

    // Waits for its end and returns its status, as waitpid gives it.
    int wait();
    // Does not wait. Once it has ended, wait() returns its status.
    bool hasEnded();

private:
    pid_t m_pid = -1;  // -1: has been waited for
    int m_status = 0;  // then
    int m_input = -1, m_output = -1;
};

}  // namespace process
