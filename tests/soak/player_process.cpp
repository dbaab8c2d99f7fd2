#include "player_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace soak {

namespace {

constexpr int kLongestSilence = 300000;  // ms; a block takes less than a second

}  // namespace

PlayerProcess::PlayerProcess(const std::string &libraryFolder, std::uint64_t seed, int mostThreads) {
    int requests[2], answers[2];
    if (pipe2(requests, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0) throw std::runtime_error("no pipes");
    const std::string seedText = std::to_string(seed), threadsText = std::to_string(mostThreads);
    m_child = fork();
    if (m_child < 0) throw std::runtime_error("no process");
    if (m_child == 0) {
        dup2(requests[0], STDIN_FILENO);
        dup2(answers[1], STDOUT_FILENO);
        dup2(memfd_create("messages", MFD_CLOEXEC), STDERR_FILENO);  // a file of its own, which the recorder reads
        setenv("LD_LIBRARY_PATH", libraryFolder.c_str(), 1);
        execl(ODE_MT_SOAK_PLAYER, ODE_MT_SOAK_PLAYER, seedText.c_str(), threadsText.c_str(), static_cast<char *>(nullptr));
        _exit(127);
    }
    close(requests[0]);
    close(answers[1]);
    m_requests = requests[1];
    m_answers = answers[0];
}

PlayerProcess::~PlayerProcess() {
    if (m_requests >= 0) close(m_requests);
    close(m_answers);
    if (m_child < 0) return;
    kill(m_child, SIGKILL);
    waitpid(m_child, nullptr, 0);
}

void PlayerProcess::askForBlock() {
    if (write(m_requests, "\n", 1) != 1) throw std::runtime_error("a player takes no requests any more");
}

void PlayerProcess::askForTheEnd() {
    close(m_requests);
    m_requests = -1;
}

Block PlayerProcess::answer() {
    for (;;) {
        const std::size_t end = m_read.find('\n');
        if (end != std::string::npos) {
            const Block block = blockOf(m_read.substr(0, end));
            m_read.erase(0, end + 1);
            return block;
        }
        pollfd waiting{m_answers, POLLIN, 0};
        if (poll(&waiting, 1, kLongestSilence) == 0) throw std::runtime_error("a player has sent nothing for five minutes");
        char text[4096];
        const ssize_t length = read(m_answers, text, sizeof text);
        if (length <= 0) throw std::runtime_error("a player has ended in the middle of its work");
        m_read.append(text, static_cast<std::size_t>(length));
    }
}

void PlayerProcess::waitForExit() {
    int status = 0;
    waitpid(m_child, &status, 0);
    m_child = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error("a player did not exit with 0, but with status " + std::to_string(status));
}

}  // namespace soak
