// odemt_soak_player on one of the two libraries.
#pragma once

#include "block.h"

#include <sys/types.h>

#include <cstdint>
#include <string>

namespace soak {

class PlayerProcess {
public:
    // Throws std::runtime_error if it cannot be started.
    PlayerProcess(const std::string &libraryFolder, std::uint64_t seed, int mostThreads);
    ~PlayerProcess();
    PlayerProcess(const PlayerProcess &) = delete;
    PlayerProcess &operator=(const PlayerProcess &) = delete;

    void askForBlock();
    void askForTheEnd();
    // Waits; throws std::runtime_error if the process has ended, or has sent nothing for five minutes.
    Block answer();
    // Waits for the exit of a process that was told to end. Throws std::runtime_error unless it exits with 0.
    void waitForExit();

private:
    pid_t m_child = -1;
    int m_requests = -1, m_answers = -1;
    std::string m_read;  // and not yet taken
};

}  // namespace soak
