#include "machine.h"

#include <fstream>
#include <thread>

namespace bench {

std::string readProcessor(std::istream &cpuinfo) {
    for (std::string line; std::getline(cpuinfo, line);) {
        if (line.compare(0, 10, "model name") != 0) continue;
        const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
        return value == std::string::npos ? "" : line.substr(value);
    }
    return "";
}

Machine thisMachine() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    return {readProcessor(cpuinfo), std::thread::hardware_concurrency()};
}

}  // namespace bench
