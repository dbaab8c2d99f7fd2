#include "error_output.h"

#include "loader/load_error.h"

#include <iostream>

namespace bench {

void printError(const std::string &message) { std::cerr << worlds::printable(message) << "\n"; }

int printOptionError(const std::string &message) {
    printError(message);
    std::cerr << "Run with --help for more information.\n";
    return kWrongOption;
}

int exitCodeOf(const CLI::App &app, const CLI::ParseError &error) {
    const bool isHelp = error.get_exit_code() == 0;
    return isHelp ? app.exit(error) : printOptionError(error.what());
}

}  // namespace bench
