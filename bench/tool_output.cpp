#include "tool_output.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "support/text.h"

namespace bench {

// What takes the place of one cannot be used the way that it is used.
void keepStandardFiles() {
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(file, F_GETFD) == -1 && errno == EBADF)
            (void)!open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    for (const int number : {SIGPIPE, SIGXFSZ}) signal(number, SIG_IGN);
}

void print(const std::string &text) {
    errno = 0;
    if (!(std::cout << text << std::flush))
        throw std::runtime_error(std::string("cannot write to standard output: ") + std::strerror(errno));
}

int exitCodeAfterOutput(int exitCode) {
    try {
        print("");
        return exitCode;
    } catch (const std::runtime_error &error) {
        std::cerr << error.what() << "\n";
        return exitCode == 0 ? 1 : exitCode;
    }
}

void printError(const std::string &message) { std::cerr << support::printable(message) << "\n"; }

int printOptionError(const std::string &message) {
    printError(message);
    std::cerr << "Run with --help for more information.\n";
    return kWrongOption;
}

bool readCommandLine(const CLI::App &app, const std::function<void()> &read, int &exitCode) {
    try {
        read();
        return true;
    } catch (const CLI::ParseError &error) {
        const bool isHelp = error.get_exit_code() == 0;
        exitCode = isHelp ? app.exit(error) : printOptionError(error.what());
    } catch (const std::exception &error) {
        exitCode = printOptionError(error.what());
    }
    return false;
}

namespace {

constexpr suseconds_t kInterval = 200'000;  // microseconds

void endIfNobodyReads(int) {
    const int kept = errno;
    pollfd output{STDOUT_FILENO, 0, 0};
    if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) _exit(1);
    errno = kept;
}

void setTimer(suseconds_t interval) {
    const itimerval timer = {{0, interval}, {0, interval}};
    setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

ReaderWatch::ReaderWatch() {
    struct sigaction action {};
    action.sa_handler = endIfNobodyReads;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    setTimer(kInterval);
}

ReaderWatch::~ReaderWatch() {
    setTimer(0);
    signal(SIGALRM, SIG_DFL);
}

}  // namespace bench
