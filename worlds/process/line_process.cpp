#include "process/line_process.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

namespace process {

namespace {

using Clock = std::chrono::steady_clock;

std::string describe(int status) { return (WIFSIGNALED(status) ? "killed by " : "ended with ") + endingOf(status); }

}  // namespace

LineProcess::LineProcess(const std::vector<std::string> &command, const Environment &changes)
    : m_errors(memfd_create("standard error", MFD_CLOEXEC)) {
    try {
        m_process.emplace(command, changes, m_errors);
    } catch (const std::runtime_error &error) {
        close(m_errors);
        throw LineProcessError(error.what());
    }
}

LineProcess::~LineProcess() { close(m_errors); }

void LineProcess::writeLine(const std::string &line) {
    const std::string text = line + "\n";
    const ssize_t written = write(m_process->input(), text.data(), text.size());
    if (written != static_cast<ssize_t>(text.size())) throw LineProcessError(ending());
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

// The end of what the process wrote to its standard error, on one line.
std::string LineProcess::lastErrors() const {
    constexpr off_t kMaxText = 400;  // bytes
    struct stat file {};
    fstat(m_errors, &file);
    const off_t size = file.st_size;
    const off_t start = size > kMaxText ? size - kMaxText : 0;
    std::string text(static_cast<std::size_t>(size - start), '\0');
    const ssize_t count = pread(m_errors, text.data(), text.size(), start);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    for (char &c : text)
        if (c == '\n') c = ' ';
    const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : ": " + text.substr(first, last - first + 1);
}

}  // namespace process
