#include <sys/wait.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "surroundings.h"

namespace faults {

// A German locale, made for this if the machine has none.
std::uint64_t withDecimalComma() {
    char pattern[] = "/tmp/odemt_locale_XXXXXX";
    const std::string folder = mkdtemp(pattern);
    const std::string command =
        "localedef --no-archive -i de_DE -f UTF-8 " + folder + "/de_DE.UTF-8 >/dev/null 2>&1";
    const bool isMade = std::system(command.c_str()) == 0;
    setenv("LOCPATH", folder.c_str(), 1);
    const bool isSet = isMade && std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    std::filesystem::remove_all(folder);
    if (!isSet || std::string(std::localeconv()->decimal_point) != ",") return 0;
    return playFrames();
}

}  // namespace faults
