#include "child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <thread>

extern char **environ;

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> changedEnvironment(const ChildProcess::Environment &changes) {
    std::vector<std::string> result;
    for (char **entry = environ; *entry; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        if (!changes.count(name)) result.emplace_back(*entry);
    }
    for (const auto &[name, value] : changes)
        if (!value.empty()) result.push_back(name + "=" + value);
    return result;
}

std::vector<char *> pointers(std::vector<std::string> &strings) {
    std::vector<char *> result;
    for (std::string &string : strings) result.push_back(string.data());
    result.push_back(nullptr);
    return result;
}

std::string describeStatus(int status) {
    if (WIFSIGNALED(status)) {
        const int number = WTERMSIG(status);
        return "killed by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
    }
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string> &command, const Environment &changes) {
    int toChild[2], fromChild[2];
    if (pipe2(toChild, O_CLOEXEC) != 0 || pipe2(fromChild, O_CLOEXEC) != 0)
        throw ChildError("cannot make a pipe: " + std::string(std::strerror(errno)));
    m_errors = memfd_create("standard error", MFD_CLOEXEC);
    signal(SIGPIPE, SIG_IGN);  // a write to a child that has died fails instead

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, toChild[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fromChild[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, m_errors, STDERR_FILENO);
    std::vector<std::string> arguments = command, environment = changedEnvironment(changes);
    const int error = posix_spawn(&m_pid, command[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    close(toChild[0]);
    close(fromChild[1]);
    m_input = toChild[1];
    m_output = fromChild[0];
    if (error != 0) {
        m_pid = -1;
        for (int file : {m_input, m_output, m_errors}) close(file);
        throw ChildError("cannot start " + command[0] + ": " + std::strerror(error));
    }
}

ChildProcess::~ChildProcess() {
    for (int file : {m_input, m_output, m_errors}) close(file);
    if (m_pid < 0) return;
    kill(m_pid, SIGKILL);
    waitpid(m_pid, nullptr, 0);
}

void ChildProcess::writeLine(const std::string &line) {
    const std::string text = line + "\n";
    const ssize_t written = write(m_input, text.data(), text.size());
    if (written != static_cast<ssize_t>(text.size())) throw ChildError(ending());
}

std::string ChildProcess::readLine(std::chrono::milliseconds limit) {
    const Clock::time_point deadline = Clock::now() + limit;
    for (;;) {
        const std::size_t end = m_buffer.find('\n');
        if (end != std::string::npos) {
            const std::string line = m_buffer.substr(0, end);
            m_buffer.erase(0, end + 1);
            return line;
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        pollfd wait{m_output, POLLIN, 0};
        if (left.count() <= 0 || poll(&wait, 1, static_cast<int>(left.count())) == 0)
            throw ChildError("no answer within " + std::to_string(limit.count() / 1000) + " s" +
                             lastErrors());
        char bytes[4096];
        const ssize_t count = read(m_output, bytes, sizeof bytes);
        if (count == 0) throw ChildError(ending());
        if (count > 0) m_buffer.append(bytes, static_cast<std::size_t>(count));
    }
}

std::string ChildProcess::ending() {
    using namespace std::chrono_literals;
    for (const Clock::time_point deadline = Clock::now() + 2s; Clock::now() < deadline;) {
        int status = 0;
        if (waitpid(m_pid, &status, WNOHANG) == m_pid) {
            m_pid = -1;
            return describeStatus(status) + lastErrors();
        }
        std::this_thread::sleep_for(1ms);
    }
    return "closed its output and went on running" + lastErrors();
}

// The end of what the child wrote to its standard error, on one line.
std::string ChildProcess::lastErrors() const {
    constexpr off_t most = 400;  // bytes
    struct stat file {};
    fstat(m_errors, &file);
    const off_t size = file.st_size;
    const off_t start = size > most ? size - most : 0;
    std::string text(static_cast<std::size_t>(size - start), '\0');
    const ssize_t count = pread(m_errors, text.data(), text.size(), start);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    for (char &c : text)
        if (c == '\n') c = ' ';
    const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : ": " + text.substr(first, last - first + 1);
}

}  // namespace bench
