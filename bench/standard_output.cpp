#include "standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>

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

}  // namespace bench
