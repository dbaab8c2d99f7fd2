#include "process/piped_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace process {

namespace {

struct Pipe {
    int reading = -1, writing = -1;

    Pipe() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe: " + std::string(std::strerror(errno)));
        reading = ends[0];
        writing = ends[1];
    }
    ~Pipe() {
        for (const int end : {reading, writing})
            if (end >= 0) close(end);
    }
    Pipe(const Pipe &) = delete;
    Pipe &operator=(const Pipe &) = delete;

    static int take(int &end) {
        const int taken = end;
        end = -1;
        return taken;
    }
};

}  // namespace

PipedProcess::PipedProcess(const std::vector<std::string> &command, const Environment &changes, int errors) {
    Pipe toChild, fromChild;
    signal(SIGPIPE, SIG_IGN);  // a write to a child that has died fails instead
    m_pid = spawn(command, changes, {toChild.reading, fromChild.writing, errors});
    m_input = Pipe::take(toChild.writing);
    m_output = Pipe::take(fromChild.reading);
}

PipedProcess::~PipedProcess() {
    closeInput();
    close(m_output);
    if (m_pid < 0) return;
    kill(m_pid, SIGKILL);
    waitpid(m_pid, nullptr, 0);
}

void PipedProcess::closeInput() {
    if (m_input >= 0) close(m_input);
    m_input = -1;
}

int PipedProcess::wait() {
    while (m_pid >= 0 && waitpid(m_pid, &m_status, 0) < 0 && errno == EINTR) {
    }
    m_pid = -1;
    return m_status;
}

bool PipedProcess::hasEnded() {
    if (m_pid >= 0 && waitpid(m_pid, &m_status, WNOHANG) == m_pid) m_pid = -1;
    return m_pid < 0;
}

}  // namespace process
