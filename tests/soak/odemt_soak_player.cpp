// Plays blocks of frames on whatever libode.so.8 the loader finds: one for each line on standard input, and a line of JSON
// of each (block.h). When the input ends, everything is destroyed, and a last line reports what is left.
#include "block.h"
#include "town.h"

#include "engine_statistics.h"

#include <ode/ode.h>

#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace {

std::size_t residentBytes() {
    std::size_t size = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> size >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

int threads() {
    return static_cast<int>(std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}));
}

void tell(std::uint64_t hash, std::uint64_t frames) {
    const exactness::Engine engine = exactness::runningEngine();
    const struct mallinfo2 memory = mallinfo2();
    std::cout << soak::lineOf({engine.library, hash, memory.uordblks + memory.hblkhd, residentBytes(), threads(),
                               engine.maxWorkers, frames})
              << std::endl;
}

void play(std::uint64_t seed, int maxThreads) {
    dInitODE2(0);
    std::uint64_t hash = 0, frames = 0;
    {
        soak::Town town(seed, maxThreads);
        for (std::string request; std::getline(std::cin, request);) {
            hash = town.playBlock();
            frames = town.frames();
            tell(hash, frames);
        }
    }
    dCloseODE();
    tell(hash, frames);
}

}  // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::cerr << "usage: odemt_soak_player SEED MOST_THREADS\n";
        return 2;
    }
    try {
        play(std::strtoull(argv[1], nullptr, 10), std::atoi(argv[2]));
        return 0;
    } catch (const std::exception &error) {
        std::cerr << "odemt_soak_player: " << error.what() << '\n';
        return 1;
    }
}
