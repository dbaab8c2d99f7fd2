// odemt_info as a user runs it: what it says of the release of ODE, on ours and on another libode.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <filesystem>

#include "platform.h"
#include "shell_run.h"

namespace {

// Returns "" if there is no such fact.
std::string factOn(const std::string &folder, const std::string &fact) {
    const Outcome outcome = runShell("LD_LIBRARY_PATH=" + folder + " " ODEMT_INFO " --json");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    const auto facts = nlohmann::json::parse(outcome.output, nullptr, false);
    return facts.is_object() && facts.contains(fact) ? facts[fact].get<std::string>() : "";
}

}  // namespace

TEST(OdemtInfo, TellsTheReleaseInsideOurLibrary) {
    EXPECT_EQ(factOn(ODEMT_OUR_FOLDER, "ODE"), ODEMT_UPSTREAM);
    const Outcome outcome = runShell(ODEMT_INFO);
    EXPECT_NE(outcome.output.find("\nODE               " ODEMT_UPSTREAM "\n"), std::string::npos) << outcome.output;
}

// The folder stands in for a system with that release: the number of the file is what tells.
TEST(OdemtInfo, TellsTheReleaseOfAnotherLibraryByItsFile) {
    const std::string folder = testing::TempDir() + "/odemt_info_" + std::to_string(getpid());
    std::filesystem::create_directories(folder);
    for (const auto &[name, release] :
         {std::pair("libode.so.8.0.2", "0.16.2"), std::pair("libode.so.8.2.0", "0.16.6"), std::pair("other", "unknown")}) {
        std::filesystem::copy_file(ODEMT_ORACLE, folder + '/' + name);
        std::filesystem::remove(folder + "/libode.so.8");
        std::filesystem::create_symlink(name, folder + "/libode.so.8");
        EXPECT_EQ(factOn(folder, "ODE"), release) << factOn(folder, "library");
        EXPECT_EQ(factOn(folder, "ODE_MT"), "no: another libode");
    }
    std::filesystem::remove_all(folder);
}
