#include "top/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "support/deferred_signals.h"
#include "support/orphans.h"
#include "support/process.h"

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
    const support::Descriptor output(openOutput(options)), nothing(isatty(STDIN_FILENO) != 0 ? open("/dev/null", O_RDONLY | O_CLOEXEC) : -1);
    const int to = output.number() >= 0 ? output.number() : STDERR_FILENO;
    const support::Environment environment = {{"LD_LIBRARY_PATH", bench::inFront(library, "LD_LIBRARY_PATH")},
                                              {"ODE_MT_THREADS", options.threads},
                                              {"ODE_MT_STATISTICS", board.path()}};
    m_child = support::spawn(options.command, environment, {nothing.number(), to, to}, support::Group::Own);
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

namespace {

constexpr std::streamoff kBytes = 16384;

// ASCII alone: the width of anything else is the terminal's affair.
char shown(char c) {
    if (c == '\t') return ' ';
    return c >= 0x20 && c < 0x7f ? c : '?';
}

}  // namespace

std::vector<std::string> tailOf(const std::string &file, std::size_t count, std::size_t width) {
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(0, std::ios::end);
    stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - kBytes));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        line.resize(std::min(line.size(), width));
        std::transform(line.begin(), line.end(), line.begin(), shown);
        lines.push_back(line);
    }
    if (lines.size() > count) lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(count));
    return lines;
}

}  // namespace top
