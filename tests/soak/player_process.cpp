#include "player_process.h"

namespace soak {

// A block takes less than a second.
Block PlayerProcess::answer() { return blockOf(m_process.readLine(std::chrono::minutes(5))); }

PlayerProcess::PlayerProcess(const std::string &libraryFolder, std::uint64_t seed, int maxThreads)
    : m_process({ODE_MT_SOAK_PLAYER, std::to_string(seed), std::to_string(maxThreads)}, {{"LD_LIBRARY_PATH", libraryFolder}}) {}

}  // namespace soak
