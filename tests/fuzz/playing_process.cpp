#include "playing_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace fuzz {

namespace {

void writeAll(int file, const void *place, std::size_t size) {
    const auto *at = static_cast<const char *>(place);
    while (size > 0) {
        const ssize_t put = write(file, at, size);
        if (put <= 0) throw std::runtime_error("a playing process takes no scripts any more");
        at += put;
        size -= static_cast<std::size_t>(put);
    }
}

void readAll(int file, void *place, std::size_t size) {
    auto *at = static_cast<char *>(place);
    while (size > 0) {
        const ssize_t got = read(file, at, size);
        if (got <= 0) throw std::runtime_error("a playing process has ended");
        at += got;
        size -= static_cast<std::size_t>(got);
    }
}

}  // namespace

PlayingProcess::PlayingProcess(const std::string &program, const std::string &libraryFolder, const Environment &environment) {
    int requests[2], answers[2];
    if (pipe2(requests, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0) throw std::runtime_error("no pipes");
    m_child = fork();
    if (m_child < 0) throw std::runtime_error("no process");
    if (m_child == 0) {
        dup2(requests[0], STDIN_FILENO);
        dup2(answers[1], STDOUT_FILENO);
        setenv("LD_LIBRARY_PATH", libraryFolder.c_str(), 1);
        for (const auto &[name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
        execl(program.c_str(), program.c_str(), static_cast<char *>(nullptr));
        _exit(127);
    }
    close(requests[0]);
    close(answers[1]);
    m_requests = requests[1];
    m_answers = answers[0];
}

PlayingProcess::~PlayingProcess() {
    close(m_requests);
    close(m_answers);
    waitpid(m_child, nullptr, 0);
}

void PlayingProcess::ask(RequestHeader request, const std::vector<std::uint8_t> &script) {
    request.length = static_cast<std::uint32_t>(script.size());
    writeAll(m_requests, &request, sizeof request);
    writeAll(m_requests, script.data(), script.size());
}

Outcome PlayingProcess::answer() {
    Outcome outcome;
    readAll(m_answers, &outcome.header, sizeof outcome.header);
    outcome.errors.resize(outcome.header.errorLength);
    outcome.text.resize(outcome.header.textLength);
    readAll(m_answers, &outcome.errors[0], outcome.errors.size());
    readAll(m_answers, &outcome.text[0], outcome.text.size());
    return outcome;
}

}  // namespace fuzz
