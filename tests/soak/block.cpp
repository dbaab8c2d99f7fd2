#include "block.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace soak {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Block, library, hash, liveBytes, residentBytes, threads, workers, frames)

std::string lineOf(const Block &block) { return nlohmann::json(block).dump(); }

Block blockOf(const std::string &line) {
    try {
        return nlohmann::json::parse(line).get<Block>();
    } catch (const nlohmann::json::exception &) {
        throw std::runtime_error("a player ended, or sent something else: '" + line + "'");
    }
}

}  // namespace soak
