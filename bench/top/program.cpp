#include "top/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "support/orphans.h"
#include "support/process.h"
#include "support/deferred_signals.h"

namespace top {

// -1: standard error.
int Program::openOutput(const TopOptions &options) {
    int file = -1;
    if (!options.output.empty()) {
        m_output = options.output;
        file = open(m_output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    } else if (options.mode == Mode::Screen) {
        m_output = std::filesystem::temp_directory_path() / "odemt_top_XXXXXX.log";
        file = mkostemps(m_output.data(), 4, O_APPEND | O_CLOEXEC);
    } else {
        return -1;
    }
    if (file < 0) throw std::runtime_error("cannot write " + m_output + ": " + std::strerror(errno));
    return file;
}

Program::Program(const TopOptions &options, const support::TemporaryFolder &folder, const FrameBoard &board) {
    const std::string library = bench::addLibrary(folder, "ours", options.ourFolder + "/libode.so.8");
    const int output = openOutput(options), nothing = isatty(STDIN_FILENO) != 0 ? open("/dev/null", O_RDONLY | O_CLOEXEC) : -1;
    const int to = output >= 0 ? output : STDERR_FILENO;
    const support::Environment environment = {{"LD_LIBRARY_PATH", bench::inFront(library, "LD_LIBRARY_PATH")},
                                              {"ODE_MT_THREADS", options.threads},
                                              {"ODE_MT_STATISTICS", board.path()}};
    const auto closeFiles = [=] {
        if (output >= 0) close(output);
        if (nothing >= 0) close(nothing);
    };
    try {
        m_child = support::spawn(options.command, environment, {nothing, to, to}, support::Group::Own);
    } catch (...) {
        closeFiles();
        throw;
    }
    closeFiles();
}

Program::~Program() {
    if (hasEnded()) return;
    askToEnd(SIGTERM);
    endRest();
}

bool Program::hasEnded() {
    int status = 0;
    for (pid_t ended; !m_hasEnded && (ended = waitpid(-1, &status, WNOHANG)) > 0;) {
        if (ended != m_child) continue;  // an orphan of the program's
        m_hasEnded = true;
        m_status = status;
    }
    return m_hasEnded;
}

int Program::exitCode() const { return WIFEXITED(m_status) ? WEXITSTATUS(m_status) : 128 + WTERMSIG(m_status); }

void Program::askToEnd(int signal) {
    kill(-m_child, m_isAsked ? SIGKILL : signal);
    m_isAsked = true;
}

// Of its process group also those whose parents are still there.
bool Program::endRest() {
    if (!m_isAsked) return true;
    kill(-m_child, SIGTERM);
    return !support::endOrphans([](std::chrono::milliseconds most) { support::waitForSignal(most); }).areLeft;
}

}  // namespace top
