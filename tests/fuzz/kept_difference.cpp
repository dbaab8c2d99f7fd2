#include "kept_difference.h"

#include "shrinking.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace fuzz {

namespace {

// Returns the calls that were made, without their results.
Script playedScript(const std::string &text) {
    std::string calls;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#' && line.compare(0, 4, "    ") != 0) calls += line + '\n';
    return scriptOf(calls);
}

}  // namespace

std::string keepDifference(Comparison &comparison, const Input &input, const std::string &name, const std::string &folder) {
    const RequestHeader &request = input.request;
    std::string told = name + " differs\n" + settingOf(request) + comparison.lastDifference();
    Script script = playedScript(comparison.reference().text.size() > comparison.ours().text.size() ? comparison.reference().text
                                                                                                 : comparison.ours().text);
    const auto differs = [&](const Script &tried) { return comparison.compare(request, tried) == Verdict::different; };
    if (differs(script)) {
        comparison.setPatience(4);
        script = shrink(std::move(script), differs);
        comparison.setPatience(24);
        told += "made small:\n" + textOf(script) + comparison.difference(request, script);
    } else {
        told += "not again as text; played again:\n" + comparison.difference(request, input.script);
    }
    if (!folder.empty()) {
        std::filesystem::create_directories(folder);
        std::ofstream(folder + "/" + name + ".script") << settingOf(request) << textOf(script);
    }
    return told;
}

}  // namespace fuzz
