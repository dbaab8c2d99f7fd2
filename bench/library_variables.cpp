#include "library_variables.h"

#include <unistd.h>

#include <cstring>

namespace bench {

std::vector<std::string> libraryVariables() {
    const std::string prefix = "ODE_MT_";
    std::vector<std::string> names;
    for (char **entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        if (name.compare(0, prefix.size(), prefix) == 0 && name != "ODE_MT_WORLDS") names.push_back(name);
    }
    return names;
}

}  // namespace bench
