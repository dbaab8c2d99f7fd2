#include "batch/workers.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "batch/world_run.h"
#include "support/process.h"
#include "support/text_file.h"

namespace batch {

namespace {

// One in progress and one that waits, so that a worker never waits for its parent.
constexpr std::size_t kRunsAtWorker = 2;

// A run is given to no other worker after this number of workers was killed during it.
constexpr unsigned kMaxKills = 5;

// A run that ends its worker so would do it again. Other signals come from outside.
bool isOwnFault(int signal) {
    constexpr int kFaults[] = {SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE, SIGSEGV, SIGSYS, SIGXCPU, SIGXFSZ};
    return std::find(std::begin(kFaults), std::end(kFaults), signal) != std::end(kFaults);
}

// --- in the worker -----------------------------------------------------------------------------------------------

int answerFile = -1;
long runInProgress = -1;

void answer(Json line) {
    if (!support::writeAll(answerFile, line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n")) _exit(0);  // the parent is gone
}

// Of ODE: what it was in the midst of cannot be left in another way.
void endByError(int, const char *format, va_list arguments) {
    char text[1000];
    std::vsnprintf(text, sizeof text, format, arguments);
    answer(failedRun(runInProgress, text));
    _exit(1);
}

[[noreturn]] void work(const Plan &plan, int commands) {
    initialiseOde(endByError);
    std::FILE *const input = fdopen(commands, "r");
    for (long number; input != nullptr && std::fscanf(input, "%ld", &number) == 1;) {
        runInProgress = number;
        using Clock = std::chrono::steady_clock;
        const Clock::time_point begin = Clock::now();
        Json line = runWorld(plan, plan.run(number));
        line["seconds"] = std::chrono::duration<double>(Clock::now() - begin).count();
        answer(std::move(line));
    }
    _exit(0);
}

}  // namespace

Workers::Workers(const Plan &plan, unsigned count) : m_plan(plan), m_workers(count) {
    for (Worker &worker : m_workers) start(worker);
}

Workers::~Workers() {
    for (Worker &worker : m_workers) {
        if (worker.process < 0) continue;
        worker.commands.close();
        worker.answers.close();
        kill(worker.process, SIGKILL);
        support::waitFor(worker.process);
    }
}

void Workers::start(Worker &worker) {
    support::Pipe commands, answers;
    worker.process = support::forkChild();
    if (worker.process < 0) throw std::runtime_error(std::string("cannot start a worker: ") + std::strerror(errno));
    if (worker.process == 0) {
        for (Worker &other : m_workers) {
            other.commands.close();
            other.answers.close();
        }
        commands.writing.close();
        answers.reading.close();
        answerFile = answers.writing.number();
        work(m_plan, commands.reading.number());
    }
    worker.commands = std::move(commands.writing);
    worker.answers = std::move(answers.reading);
}

std::size_t Workers::outstanding() const {
    std::size_t count = m_queue.size();
    for (const Worker &worker : m_workers) count += worker.runs.size();
    return count;
}

void Workers::give(const std::vector<long> &runs) {
    m_queue.insert(m_queue.end(), runs.begin(), runs.end());
    feed();
}

// First one each, then one that waits.
void Workers::feed() {
    for (std::size_t most = 1; most <= kRunsAtWorker; ++most)
        for (Worker &worker : m_workers) {
            if (m_queue.empty()) return;
            if (worker.runs.size() >= most) continue;
            worker.runs.push_back(m_queue.front());
            m_queue.pop_front();
            // A worker that is gone is seen by its answers' end.
            support::writeAll(worker.commands.number(), std::to_string(worker.runs.back()) + "\n");
        }
}

std::vector<Json> Workers::takeAnswers(int milliseconds) {
    std::vector<pollfd> files;
    for (const Worker &worker : m_workers) files.push_back({worker.answers.number(), POLLIN, 0});
    std::vector<Json> answers;
    if (poll(files.data(), files.size(), milliseconds) <= 0) return answers;
    for (unsigned i = 0; i < count(); ++i)
        if (files[i].revents != 0) read(i, answers);
    feed();
    return answers;
}

void Workers::read(unsigned index, std::vector<Json> &answers) {
    Worker &worker = m_workers[index];
    char bytes[65536];
    const ssize_t count = ::read(worker.answers.number(), bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) return replace(index, answers);
    worker.text.append(bytes, static_cast<std::size_t>(count));
    std::size_t begin = 0;
    for (std::size_t end; (end = worker.text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        Json line = Json::parse(worker.text.begin() + static_cast<long>(begin), worker.text.begin() + static_cast<long>(end));
        line["worker"] = index;
        answers.push_back(std::move(line));
        worker.runs.pop_front();
        worker.kills = 0;
    }
    worker.text.erase(0, begin);
}

void Workers::replace(unsigned index, std::vector<Json> &answers) {
    Worker &worker = m_workers[index];
    worker.commands.close();
    worker.answers.close();
    const int status = support::waitFor(worker.process);
    worker.process = -1;
    worker.text.clear();
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const bool isFault = isOwnFault(signal) || ++worker.kills >= kMaxKills;
    if (isFault && !worker.runs.empty()) {
        answers.push_back(failedRun(worker.runs.front(), "the worker ended by signal " + std::to_string(signal)));
        worker.runs.pop_front();
        worker.kills = 0;
    }
    start(worker);
    for (const long run : worker.runs) support::writeAll(worker.commands.number(), std::to_string(run) + "\n");
}

namespace {

constexpr int kIsWrong = 1;  // exit code of the process that has written why

void endQuietly(int, const char *, va_list) { _exit(0); }  // the run says it

[[noreturn]] void tryWorlds(const Plan &plan, std::size_t first, int answer) {
    initialiseOde(endQuietly);
    const long runsOfAWorld = plan.count() / static_cast<long>(plan.worlds.size());
    for (std::size_t world = first; world < plan.worlds.size(); ++world) {
        const Run run = plan.run(static_cast<long>(world) * runsOfAWorld);
        support::writeAll(answer, std::string(1, '\0'));  // begins with this one
        try {
            tryWorld(plan, run);
        } catch (const std::exception &error) {
            support::writeAll(answer, std::string(error.what()) + " (run " + std::to_string(run.number) + ", world '" + run.world + "')");
            _exit(kIsWrong);
        }
    }
    _exit(0);
}

}  // namespace

void checkWorlds(const Plan &plan) {
    for (std::size_t first = 0; first < plan.worlds.size();) {
        const support::MemoryFile answer;
        const pid_t child = support::forkChild();
        if (child < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
        if (child == 0) tryWorlds(plan, first, answer.descriptor());
        const int status = support::waitFor(child);
        const std::string text = answer.text();
        if (WIFEXITED(status) && WEXITSTATUS(status) == kIsWrong) throw std::runtime_error(text.substr(text.rfind('\0') + 1));
        // Behind one that has ended the process, if it has.
        first += std::max<std::size_t>(1, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\0')));
    }
}

}  // namespace batch
