// odemt_soak_player on one of the two libraries.
#pragma once

#include <cstdint>
#include <string>

#include "block.h"
#include "support/process.h"

namespace soak {

class PlayerProcess {
public:
    // Throws std::runtime_error if it cannot be started.
    PlayerProcess(const std::string &libraryFolder, std::uint64_t seed, int maxThreads);

    void askForBlock() { m_process.writeLine(""); }
    void askForTheEnd() { m_process.writeEnd(); }
    // Waits; throws std::runtime_error if the process has ended, or has told nothing for five minutes.
    Block answer();
    // Of a process that was asked for the end. Throws std::runtime_error unless it exits with 0.
    void waitForExit() { m_process.waitForExit(); }

private:
    support::LineProcess m_process;
};

}  // namespace soak
