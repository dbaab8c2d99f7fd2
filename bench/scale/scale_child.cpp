// odemt_scale_child: runs frames of one world on the libode.so.8 that the loader finds, as the environment says, for odemt_scale:
//
//   odemt_scale_child WORLD LOG        LOG: file for standard error, where the library says what its workers are
//
// For each line with a number of frames it prints one with their times: {"frame": [ns …], "step": [ns …], "hash": …}.
#include "tool_output.h"
#include "protocol.h"
#include "scenes/state_hash.h"
#include "world_source.h"

#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <stdexcept>

namespace {

double now() { return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void countNothing(int, const char *, va_list) {}  // messages of a world would be timed as well

void run(scenes::Scene &scene, int frames) {
    std::vector<double> frameNs, stepNs;
    for (int i = 0; i < frames; ++i) {
        const double start = now();
        scene.control();
        scene.collide();
        const double collided = now();
        scene.step();
        const double stepped = now();
        scene.finish();
        frameNs.push_back(now() - start);
        stepNs.push_back(stepped - collided);
    }
    const nlohmann::json answer = {{"frame", frameNs}, {"step", stepNs}, {"hash", scenes::stateHash(scene.inventory())}};
    bench::print(answer.dump() + "\n");
}

std::unique_ptr<scenes::Scene> load(const std::string &world) {
    const bench::ReaderWatch watch;
    std::vector<std::string> warnings;
    return bench::openWorld(world, {false, ""}, warnings);
}

void serve(const std::string &world) {
    const std::unique_ptr<scenes::Scene> scene = load(world);
    for (std::string line; std::getline(std::cin, line);) run(*scene, std::stoi(line));
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    if (argc != 3) return bench::printOptionError("odemt_scale_child is started by odemt_scale");
    constexpr mode_t kReadableByAll = 0644;
    const int log = open(argv[2], O_WRONLY | O_CREAT | O_TRUNC, kReadableByAll);
    if (log >= 0) dup2(log, STDERR_FILENO);
    dInitODE2(0);
    dSetMessageHandler(countNothing);
    int code = 0;
    try {
        serve(argv[1]);
    } catch (const std::exception &error) {
        bench::printError(error.what());
        code = 1;
    }
    dCloseODE();
    return code;
}
