#include "engine_run.h"

#include "support/process.h"
#include "support/child_run.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace quality {

namespace {

std::string folderOf(const Engine &engine) {
    const char *const given = std::getenv(engine.isOurs ? "ODE_MT_LIBRARY_DIR" : "ODE_MT_STOCK_LIBRARY_DIR");
    if (given != nullptr) return given;
    return engine.isOurs ? ODE_MT_LIBRARY_DIR : ODE_MT_STOCK_LIBRARY_DIR;
}

}  // namespace

Engine Engine::fast(std::map<std::string, std::string> variables) {
    variables["ODE_MT_SOLVER"] = "fast";
    return {true, std::move(variables)};
}

nlohmann::json answerOf(const Engine &engine, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), ODE_MT_QUALITY_PROGRAM);
    support::Environment variables(engine.variables.begin(), engine.variables.end());
    const std::string folder = folderOf(engine);
    variables["LD_LIBRARY_PATH"] = folder;
    const support::Ending child = support::runProgram(arguments, variables);
    std::string command;
    for (const std::string &argument : arguments) command += argument + ' ';
    if (!child.exitedWith(0)) throw std::runtime_error(command + "on " + folder + ": " + child.text() + "\n" + child.errors);
    nlohmann::json answer = nlohmann::json::parse(child.output);
    const std::string library = answer["library"];
    if (!std::filesystem::equivalent(std::filesystem::path(library).parent_path(), folder))
        throw std::runtime_error(command + "runs on " + library + ", not in " + folder);
    return answer;
}

}  // namespace quality
