// Programs in processes of their own: started with other variables and standard files than this process's, written to, and read from.
//
// Threading: an object belongs to one thread.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace support {

// Variables on top of this process's; an empty value removes the variable.
using Environment = std::map<std::string, std::string>;

struct StandardFiles {
    int input = -1, output = -1, errors = -1;  // -1: this process's
};

// Own: the process leads a process group, so that signals reach whatever it starts, and its signals are as a shell gives them.
enum class Group { Ours, Own };

// Starts the program, by its path or by its name in PATH, with its arguments. Throws std::runtime_error, which names the program, if it
// cannot be started.
pid_t spawn(const std::vector<std::string> &command, const Environment &changes, const StandardFiles &files, Group group = Group::Ours);

// Returns the child of fork(), which ends with this process, and in the child 0. Requires that no threads are running.
pid_t forkChild();

// Waits for the end of a child and returns its status, as waitpid gives it.
int waitFor(pid_t child);

// "exit code 2", "signal 11 (Segmentation fault)". `status`: as waitpid gives it.
std::string endingOf(int status);

// A file descriptor that is closed with the object.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : m_number(number) {}
    Descriptor(Descriptor &&other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor &operator=(Descriptor &&other) noexcept {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~Descriptor() { close(); }

    int number() const { return m_number; }
    void close();

private:
    int m_number;  // -1: none
};

// Its ends are closed in programs that are started.
struct Pipe {
    Descriptor reading, writing;

    Pipe();  // throws std::runtime_error
};

// A file without a name, in memory, as a standard file of a child. What several processes write is appended.
class MemoryFile {
public:
    MemoryFile();  // throws std::runtime_error

    int descriptor() const { return m_file.number(); }
    std::size_t size() const;
    // Returns the text from the byte `begin` to the end.
    std::string text(std::size_t begin = 0) const;
    // Replaces the text, which is then read from its beginning. Throws std::runtime_error.
    void write(const std::string &text) const;

private:
    Descriptor m_file;
};

// A process whose standard input and output are pipes of ours.
class PipedProcess {
public:
    // `errors`: its standard error, -1: this process's. Throws std::runtime_error if it cannot be started.
    PipedProcess(const std::vector<std::string> &command, const Environment &changes, int errors = -1);
    ~PipedProcess();  // closes the pipes, and kills it if it has not been waited for
    PipedProcess(const PipedProcess &) = delete;
    PipedProcess &operator=(const PipedProcess &) = delete;

    int input() const { return m_input.number(); }  // to be written to
    int output() const { return m_output.number(); }
    void closeInput() { m_input.close(); }

    // Waits for its end and returns its status, as waitpid gives it.
    int wait();
    // Does not wait. Once it has ended, wait() returns its status.
    bool hasEnded();

private:
    pid_t m_pid = -1;  // -1: has been waited for
    int m_status = 0;  // then
    Descriptor m_input, m_output;
};

// A process that did not answer: it could not be started, ended, or took too long. The text says which,
// with exit code or signal and the last lines of its standard error.
class LineProcessError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A process that answers lines with lines, within a limit of time.
class LineProcess {
public:
    // Its standard error is a file of its own.
    LineProcess(const std::vector<std::string> &command, const Environment &changes);  // its destructor kills it if it still runs

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

    MemoryFile m_errors;
    std::optional<PipedProcess> m_process;
    std::string m_buffer;  // read, not yet asked for
};

}  // namespace support
