// A process that answers lines with lines: started, spoken to with a time limit, and ended.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

// A child that did not answer: it could not be started, ended, or took too long. The text says which,
// with exit code or signal and the last lines of its standard error.
class ChildError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class ChildProcess {
public:
    using Environment = std::map<std::string, std::string>;

    // Runs the program with our environment and `changes` on top of it; an empty value removes the
    // variable.
    ChildProcess(const std::vector<std::string> &command, const Environment &changes);
    ~ChildProcess();  // kills it if it still runs
    ChildProcess(const ChildProcess &) = delete;
    ChildProcess &operator=(const ChildProcess &) = delete;

    void writeLine(const std::string &line);
    std::string readLine(std::chrono::milliseconds limit);

private:
    std::string ending();  // how a child that has closed its output ended
    std::string lastErrors() const;

    pid_t m_pid = -1;
    int m_input = -1, m_output = -1, m_errors = -1;
    std::string m_buffer;  // read, not yet asked for
};

}  // namespace bench
