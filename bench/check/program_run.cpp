#include "check/program_run.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "support/deferred_signals.h"

namespace check {

ProgramInput::ProgramInput(int source) : m_source(isatty(source) ? -1 : source), m_isEnded(m_source < 0) {}

void ProgramInput::readSource() {
    char bytes[1 << 16];
    const ssize_t count = read(m_source, bytes, sizeof bytes);
    if (count > 0)
        m_text.append(bytes, static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
        m_isEnded = true;
}

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double seconds(const timeval &time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

void neverWait(const support::Descriptor &file) { fcntl(file.number(), F_SETFL, fcntl(file.number(), F_GETFL) | O_NONBLOCK); }

class Runner {
public:
    Runner(const RunSettings &settings, ProgramInput &input) : m_settings(settings), m_input(input) {}

    ProgramRun run() {
        start();
        while (!hasEnded()) {
            askToEnd();
            exchange(waitingTime());
        }
        m_run.seconds = std::chrono::duration<double>(m_end - m_start).count();
        endRest();
        for (const Clock::time_point limit = Clock::now() + 1s; isListening() && Clock::now() < limit;) exchange(50ms);
        m_input.end();
        return std::move(m_run);
    }

private:
    void start() {
        support::Pipe in, out, errors;
        const support::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
        const bool isShown = m_settings.showOutput;
        const support::StandardFiles files = {m_input.isEmpty() ? nothing.number() : in.reading.number(),
                                              isShown ? STDERR_FILENO : out.writing.number(),
                                              isShown ? -1 : errors.writing.number()};
        m_start = Clock::now();
        m_child = support::spawn(m_settings.command, m_settings.environment, files, support::Group::Own);
        if (!m_input.isEmpty()) m_toChild = std::move(in.writing);
        m_output = std::move(out.reading);
        m_errors = std::move(errors.reading);
        for (const support::Descriptor *const file : {&m_toChild, &m_output, &m_errors})
            if (file->number() >= 0) neverWait(*file);
    }

    bool hasEnded() {
        rusage usage{};
        for (int status = 0; const pid_t ended = wait4(-1, &status, WNOHANG, &usage);) {
            if (ended < 0) return false;
            if (ended != m_child) continue;  // an orphan of the program's
            m_run.status = status;
            m_end = Clock::now();
            m_run.cpuSeconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
            return true;
        }
        return false;
    }

    // First politely; whoever asks twice, or does not want to wait, is obeyed at once.
    void askToEnd() {
        const bool isLate = m_settings.limit.count() > 0 && Clock::now() - m_start > m_settings.limit;
        if (m_interrupts == 0 && !isLate) return;
        if (m_run.end == ProgramRun::End::Itself) {
            m_run.end = m_interrupts > 0 ? ProgramRun::End::Interrupt : ProgramRun::End::Limit;
            m_asked = Clock::now();
            kill(-m_child, m_interrupts > 0 ? SIGINT : SIGTERM);
        } else if (m_interrupts > 1 || (m_run.end == ProgramRun::End::Limit && Clock::now() - m_asked > 2s)) {
            kill(-m_child, SIGKILL);
        }
    }

    // Signals end the wait, a child's end among them.
    std::chrono::milliseconds waitingTime() const {
        if (m_run.end != ProgramRun::End::Itself) return 50ms;
        if (m_settings.limit.count() == 0) return 1h;
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(m_settings.limit - (Clock::now() - m_start));
        return std::clamp<std::chrono::milliseconds>(left + 1ms, 0ms, 1h);
    }

    bool isListening() const { return m_output.number() >= 0 || m_errors.number() >= 0; }

    void exchange(std::chrono::milliseconds most) {
        const bool isGiving = m_toChild.number() >= 0, hasMore = m_given < m_input.text().size();
        if (isGiving && !hasMore && m_input.isEnded()) m_toChild.close();
        pollfd files[] = {{m_output.number(), POLLIN, 0},
                          {m_errors.number(), POLLIN, 0},
                          {hasMore ? m_toChild.number() : -1, POLLOUT, 0},
                          {isGiving && !hasMore ? m_input.source() : -1, POLLIN, 0},
                          {m_signals.number(), POLLIN, 0}};
        if (poll(files, 5, static_cast<int>(most.count())) <= 0) return;
        if (files[0].revents != 0) listen(m_output, m_run.output);
        if (files[1].revents != 0) listen(m_errors, m_run.errors);
        if (files[2].revents != 0) give();
        if (files[3].revents != 0) m_input.readSource();
        while (const int signal = support::waitForSignal(0ms))
            if (signal != SIGCHLD) ++m_interrupts;
    }

    static void listen(support::Descriptor &file, ProgramOutput &to) {
        char bytes[1 << 16];
        const ssize_t count = read(file.number(), bytes, sizeof bytes);
        if (count > 0)
            to.append(bytes, static_cast<std::size_t>(count));
        else if (count == 0 || (errno != EINTR && errno != EAGAIN))
            file.close();
    }

    void give() {
        const ssize_t count = write(m_toChild.number(), m_input.text().data() + m_given, m_input.text().size() - m_given);
        if (count > 0)
            m_given += static_cast<std::size_t>(count);
        else if (errno != EINTR && errno != EAGAIN)
            m_toChild.close();  // it reads no more
    }

    // Of its process group also those whose parents are still there.
    void endRest() {
        kill(-m_child, SIGTERM);
        m_run.orphans = support::endOrphans([this](std::chrono::milliseconds most) { exchange(most); });
    }

    const RunSettings &m_settings;
    ProgramInput &m_input;
    std::size_t m_given = 0;  // bytes of the input
    ProgramRun m_run;
    pid_t m_child = -1;
    const support::Descriptor m_signals = support::signalFile();
    int m_interrupts = 0;  // since the run was started
    Clock::time_point m_start, m_end, m_asked;
    support::Descriptor m_toChild, m_output, m_errors;
};

}  // namespace

ProgramRun runProgram(const RunSettings &settings, ProgramInput &input) { return Runner(settings, input).run(); }

}  // namespace check
