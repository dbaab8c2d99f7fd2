// Runs odemt_quality on an engine and reads what it prints.
#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace quality {

struct Engine {
    bool isOurs;
    std::map<std::string, std::string> variables;

    static Engine debian() { return {false, {}}; }
    // ODE_MT with the solver fast.
    static Engine fast(std::map<std::string, std::string> variables = {});
};

// Throws std::runtime_error if the program fails or runs on another library.
nlohmann::json answerOf(const Engine &engine, std::vector<std::string> arguments);

}  // namespace quality
