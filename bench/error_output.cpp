#include "error_output.h"

#include "support/text.h"

#include <iostream>

namespace bench {

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

}  // namespace bench
