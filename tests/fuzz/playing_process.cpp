#include "playing_process.h"

#include <unistd.h>

#include <stdexcept>
#include <utility>

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

support::Environment withLibrary(support::Environment environment, const std::string &folder) {
    environment["LD_LIBRARY_PATH"] = folder;
    return environment;
}

}  // namespace

PlayingProcess::PlayingProcess(const std::vector<std::string> &command, const std::string &libraryFolder, support::Environment environment)
    : m_process(command, withLibrary(std::move(environment), libraryFolder)) {}

PlayingProcess::~PlayingProcess() {
    m_process.closeInput();
    m_process.wait();
}

void PlayingProcess::ask(RequestHeader request, const std::vector<std::uint8_t> &script) {
    request.length = static_cast<std::uint32_t>(script.size());
    writeAll(m_process.input(), &request, sizeof request);
    writeAll(m_process.input(), script.data(), script.size());
}

Outcome PlayingProcess::answer() {
    Outcome outcome;
    readAll(m_process.output(), &outcome.header, sizeof outcome.header);
    outcome.errors.resize(outcome.header.errorLength);
    outcome.text.resize(outcome.header.textLength);
    readAll(m_process.output(), &outcome.errors[0], outcome.errors.size());
    readAll(m_process.output(), &outcome.text[0], outcome.text.size());
    return outcome;
}

}  // namespace fuzz
