#include "support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include "support/text_file.h"

extern char **environ;

namespace support {

namespace {

using Clock = std::chrono::steady_clock;

std::string describe(int status) { return (WIFSIGNALED(status) ? "killed by " : "ended with ") + endingOf(status); }

std::vector<std::string> changedEnvironment(const Environment &changes) {
    std::vector<std::string> result;
    for (char **entry = environ; *entry != nullptr; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        if (changes.count(name) == 0) result.emplace_back(*entry);
    }
    for (const auto &[name, value] : changes)
        if (!value.empty()) result.push_back(name + '=' + value);
    return result;
}

std::vector<char *> pointers(std::vector<std::string> &strings) {
    std::vector<char *> result;
    for (std::string &string : strings) result.push_back(string.data());
    result.push_back(nullptr);
    return result;
}

void leadGroup(posix_spawnattr_t &attributes) {
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
}

}  // namespace

pid_t spawn(const std::vector<std::string> &command, const Environment &changes, const StandardFiles &files, Group group) {
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (group == Group::Own) leadGroup(attributes);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const auto give = [&](int file, int standardFile) {
        if (file >= 0) posix_spawn_file_actions_adddup2(&actions, file, standardFile);
    };
    give(files.input, STDIN_FILENO);
    give(files.output, STDOUT_FILENO);
    give(files.errors, STDERR_FILENO);
    std::vector<std::string> arguments = command, environment = changedEnvironment(changes);
    pid_t child = -1;
    const int error = posix_spawnp(&child, command[0].c_str(), &actions, &attributes, pointers(arguments).data(),
                                   pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw std::runtime_error("cannot start " + command[0] + ": " + std::strerror(error));
    return child;
}

pid_t forkChild() {
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) _exit(0);  // it has ended before
    }
    return child;
}

int waitFor(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string endingOf(int status) {
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    const int number = WTERMSIG(status);
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
}

void Descriptor::close() {
    if (m_number >= 0) ::close(m_number);
    m_number = -1;
}

Pipe::Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe: " + std::string(std::strerror(errno)));
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
}

MemoryFile::MemoryFile() : m_file(memfd_create("text", MFD_CLOEXEC)) {
    if (m_file.number() < 0 || fcntl(m_file.number(), F_SETFL, O_APPEND) != 0)
        throw std::runtime_error("cannot make a file in memory: " + std::string(std::strerror(errno)));
}

std::size_t MemoryFile::size() const {
    struct stat file {};
    fstat(m_file.number(), &file);
    return static_cast<std::size_t>(file.st_size);
}

std::string MemoryFile::text(std::size_t begin) const {
    const std::size_t end = size();
    std::string text(end > begin ? end - begin : 0, '\0');
    const ssize_t count = pread(m_file.number(), text.data(), text.size(), static_cast<off_t>(begin));
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

void MemoryFile::write(const std::string &text) const {
    if (ftruncate(m_file.number(), 0) != 0 || !writeAll(m_file.number(), text))
        throw std::runtime_error("a file in memory takes no text");
    lseek(m_file.number(), 0, SEEK_SET);
}

PipedProcess::PipedProcess(const std::vector<std::string> &command, const Environment &changes, int errors) {
    Pipe toChild, fromChild;
    signal(SIGPIPE, SIG_IGN);  // a write to a child that has died fails instead
    m_pid = spawn(command, changes, {toChild.reading.number(), fromChild.writing.number(), errors});
    m_input = std::move(toChild.writing);
    m_output = std::move(fromChild.reading);
}

PipedProcess::~PipedProcess() {
    m_input.close();
    m_output.close();
    if (m_pid < 0) return;
    kill(m_pid, SIGKILL);
    waitFor(m_pid);
}

int PipedProcess::wait() {
    if (m_pid >= 0) m_status = waitFor(m_pid);
    m_pid = -1;
    return m_status;
}

bool PipedProcess::hasEnded() {
    if (m_pid >= 0 && waitpid(m_pid, &m_status, WNOHANG) == m_pid) m_pid = -1;
    return m_pid < 0;
}

LineProcess::LineProcess(const std::vector<std::string> &command, const Environment &changes) {
    try {
        m_process.emplace(command, changes, m_errors.descriptor());
    } catch (const std::runtime_error &error) {
        throw LineProcessError(error.what());
    }
}

void LineProcess::writeLine(const std::string &line) {
    if (!writeAll(m_process->input(), line + "\n")) throw LineProcessError(ending());
}

std::string LineProcess::readLine(std::chrono::milliseconds limit, const std::function<void()> &whileWaiting) {
    constexpr std::chrono::milliseconds kInterval{200};  // between two calls of whileWaiting
    const Clock::time_point deadline = Clock::now() + limit;
    for (;;) {
        const std::size_t end = m_buffer.find('\n');
        if (end != std::string::npos) {
            const std::string line = m_buffer.substr(0, end);
            m_buffer.erase(0, end + 1);
            return line;
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        pollfd wait{m_process->output(), POLLIN, 0};
        if (left.count() <= 0)
            throw LineProcessError("no answer within " + std::to_string(limit.count() / 1000) + " s" + lastErrors());
        if (poll(&wait, 1, static_cast<int>((whileWaiting ? std::min(left, kInterval) : left).count())) == 0) {
            if (whileWaiting) whileWaiting();
            continue;
        }
        char bytes[4096];
        const ssize_t count = read(m_process->output(), bytes, sizeof bytes);
        if (count == 0) throw LineProcessError(ending());
        if (count > 0) m_buffer.append(bytes, static_cast<std::size_t>(count));
    }
}

void LineProcess::waitForExit() {
    const int status = m_process->wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw LineProcessError(describe(status) + lastErrors());
}

std::string LineProcess::ending() {
    using namespace std::chrono_literals;
    for (const Clock::time_point deadline = Clock::now() + 2s; Clock::now() < deadline;) {
        if (m_process->hasEnded()) return describe(m_process->wait()) + lastErrors();
        std::this_thread::sleep_for(1ms);
    }
    return "closed its output and went on running" + lastErrors();
}

// Returns the end of what the process wrote to its standard error, on one line.
std::string LineProcess::lastErrors() const {
    constexpr std::size_t kMaxText = 400;  // bytes
    const std::size_t size = m_errors.size();
    std::string text = m_errors.text(size > kMaxText ? size - kMaxText : 0);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : ": " + text.substr(first, last - first + 1);
}

}  // namespace support
