#include "standard_output.h"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <stdexcept>

namespace bench {

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
