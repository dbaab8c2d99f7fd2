#include "check/play.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace check {

namespace {

// A line that the next one replaces, on a terminal alone.
void showProgress(const std::string &text) {
    if (isatty(STDERR_FILENO)) std::cerr << "\r\x1b[K" << text << std::flush;
}

}  // namespace

Player::Player(const CheckOptions &options) : m_options(options), m_input(STDIN_FILENO) {
    bench::addLibrary(m_folder, "stock", options.stockFolder + "/libode.so.8");
    bench::addLibrary(m_folder, "ours", options.ourFolder + "/libode.so.8");
    std::filesystem::create_symlink(std::filesystem::canonical(options.observer), m_folder.file("observer.so"));
}

support::Environment Player::environment(const Engine &engine, const std::string &recordFolder, std::uint64_t dumpStep) const {
    const auto number = [](std::uint64_t value) { return value != 0 ? std::to_string(value) : ""; };
    return {{"LD_PRELOAD", bench::inFront(m_folder.file("observer.so"), "LD_PRELOAD")},
            {"LD_LIBRARY_PATH", bench::inFront(libraryFolder(engine), "LD_LIBRARY_PATH")},
            {"ODE_MT_THREADS", engine.threads},
            {"ODE_MT_SOLVER", ""},
            {kFolderVariable, recordFolder},
            {kDumpVariable, number(dumpStep)},
            {kLastVariable, number(m_options.steps)}};
}

Play Player::play(const Engine &engine, std::uint64_t dumpStep) {
    Play play{engine, m_folder.file("run-" + std::to_string(++m_plays)), {}, {}};
    std::filesystem::create_directory(play.folder);
    showProgress("run " + std::to_string(m_plays) + ": " + engine.name + " ...");
    play.run =
        runProgram({m_options.command, environment(engine, play.folder, dumpStep), m_options.limit, m_options.showOutput}, m_input);
    play.record = readRunRecord(play.folder);
    showProgress("");
    return play;
}

}  // namespace check
