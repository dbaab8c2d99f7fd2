#include "check/play.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace check {

namespace {

// A variable of the environment that is a list of paths, with one more in front.
std::string inFront(const std::string &path, const char *variable) {
    const char *const others = std::getenv(variable);
    return others != nullptr && *others != '\0' ? path + ':' + others : path;
}

std::string temporaryFolder() {
    const std::string folder = std::filesystem::temp_directory_path();
    return folder.find_first_of(" :;$") == std::string::npos ? folder : "/tmp";
}

// A line that the next one replaces, on a terminal alone.
void showProgress(const std::string &text) {
    if (isatty(STDERR_FILENO)) std::cerr << "\r\x1b[K" << text << std::flush;
}

}  // namespace

RunFolder::RunFolder() {
    m_path = temporaryFolder() + "/odemt_check_XXXXXX";
    if (mkdtemp(m_path.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + m_path);
}

RunFolder::~RunFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

// The libraries are alone in their folders: programs find no others in them than without.
Player::Player(const CheckOptions &options) : m_options(options), m_input(STDIN_FILENO) {
    const auto link = [&](const std::string &folder, const std::string &library) {
        std::filesystem::create_directory(m_folder.path() + folder);
        std::filesystem::create_symlink(std::filesystem::canonical(library), m_folder.path() + folder + "/libode.so.8");
    };
    link("/stock", options.stockFolder + "/libode.so.8");
    link("/ours", options.ourFolder + "/libode.so.8");
    std::filesystem::create_symlink(std::filesystem::canonical(options.observer), m_folder.path() + "/observer.so");
}

process::Environment Player::environment(const Engine &engine, const std::string &recordFolder, std::uint64_t dumpStep) const {
    const auto number = [](std::uint64_t value) { return value != 0 ? std::to_string(value) : ""; };
    return {{"LD_PRELOAD", inFront(m_folder.path() + "/observer.so", "LD_PRELOAD")},
            {"LD_LIBRARY_PATH", inFront(libraryFolder(engine), "LD_LIBRARY_PATH")},
            {"ODE_MT_THREADS", engine.threads},
            {"ODE_MT_SOLVER", ""},
            {kFolderVariable, recordFolder},
            {kDumpVariable, number(dumpStep)},
            {kLastVariable, number(m_options.steps)}};
}

Play Player::play(const Engine &engine, std::uint64_t dumpStep) {
    Play play{engine, m_folder.path() + "/run-" + std::to_string(++m_plays), {}, {}};
    std::filesystem::create_directory(play.folder);
    showProgress("run " + std::to_string(m_plays) + ": " + engine.name + " ...");
    play.run =
        runProgram({m_options.command, environment(engine, play.folder, dumpStep), m_options.limit, m_options.showOutput}, m_input);
    play.record = readRunRecord(play.folder);
    showProgress("");
    return play;
}

}  // namespace check
