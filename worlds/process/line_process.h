// A process that answers lines with lines: started, spoken to with a time limit, and ended.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "process/piped_process.h"

namespace process {

// A process that did not answer: it could not be started, ended, or took too long. The text says which,
// with exit code or signal and the last lines of its standard error.
class LineProcessError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class LineProcess {
public:
    // Its standard error is a file of its own.
    LineProcess(const std::vector<std::string> &command, const Environment &changes);
    ~LineProcess();  // kills it if it still runs
    LineProcess(const LineProcess &) = delete;
    LineProcess &operator=(const LineProcess &) = delete;

    void writeLine(const std::string &line);
    // It will read that there are no more lines.
    void writeEnd() { m_process->closeInput(); }
    // `whileWaiting`, if given, is called some times a second until the line is there.
    std::string readLine(std::chrono::milliseconds limit, const std::function<void()> &whileWaiting = {});
    // Waits for the end of a process that comes to one. Throws LineProcessError unless it exits with 0.
    void waitForExit();

private:
    std::string ending();  // how a process that has closed its output ended
    std::string lastErrors() const;

    int m_errors = -1;
    std::optional<PipedProcess> m_process;
    std::string m_buffer;  // read, not yet asked for
};

}  // namespace process
