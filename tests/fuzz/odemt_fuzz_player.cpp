// Plays scripts on the libode.so.8 that the loader finds, each in a process of its own: requests on standard input, answers on
// standard output (protocol.h). `odemt_fuzz_player FILE` plays a script as text and prints what it sees.
#include "draw.h"
#include "player.h"
#include "protocol.h"

#include "engine_statistics.h"
#include "instruction_set.h"

#include <ode/ode.h>

#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

constexpr std::size_t kMostText = 64u << 20;
constexpr rlim_t kMostMemory = rlim_t{4} << 30;  // bytes that a script may take: height fields under huge boxes ask for more

// What a playing process leaves behind, however it ends.
struct Remains {
    std::uint64_t hash;
    std::uint32_t calls, workers;
    std::uint32_t length;
    char text[kMostText];
};

bool readAll(void *place, std::size_t size) {
    auto *at = static_cast<char *>(place);
    while (size > 0) {
        const ssize_t got = read(STDIN_FILENO, at, size);
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

void writeAll(const void *place, std::size_t size) {
    const auto *at = static_cast<const char *>(place);
    while (size > 0) {
        const ssize_t put = write(STDOUT_FILENO, at, size);
        if (put <= 0) _exit(1);
        at += put;
        size -= static_cast<std::size_t>(put);
    }
}

// Functions that Debian's library does not have.
template <class Argument>
void callIfThere(const char *name, Argument argument) {
    if (void *const found = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)(Argument)>(found)(argument);
}

void set(const RequestHeader &request) {
    callIfThere("dToggleODE_MT", static_cast<int>(request.threads));
    callIfThere("dODE_MT_SetThreadManager", kManagers[request.manager % 2]);
    callIfThere("dODE_MT_SetAlgorithm", kAlgorithms[request.algorithm % 8]);
    callIfThere("dODE_MT_SetGridCells", request.cells == 0 ? 0 : 5 + request.cells % 16);
    const std::vector<std::string> sets = exactness::instructionSets();
    if (request.instructionSet != 0 && !sets.empty()) exactness::forceInstructionSet(sets[request.instructionSet % sets.size()]);
}

void play(const RequestHeader &request, const std::vector<std::uint8_t> &script, Remains &remains) {
    alarm(request.wallSeconds);
    const rlimit time{request.seconds, request.seconds + 1u};
    setrlimit(RLIMIT_CPU, &time);
    const rlimit memory{kMostMemory, kMostMemory};
    setrlimit(RLIMIT_AS, &memory);
    if (request.perturbation != 0) setenv("ODE_MT_PERTURB", std::to_string(request.perturbation).c_str(), 1);
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    set(request);
    Player::Options options;
    options.jumps = request.jumps != 0;
    options.messages = request.messages != 0;
    options.tells = request.tells != 0;
    options.fillsStack = request.fillsStack != 0;
    options.mostCalls = request.mostCalls;
    Player *player = nullptr;
    const auto writer = [&](const std::string &text) {
        if (player != nullptr) {
            remains.hash = player->hash();
            remains.calls = static_cast<std::uint32_t>(player->calls());
        }
        if (remains.length + text.size() > kMostText) return;
        std::memcpy(remains.text + remains.length, text.data(), text.size());
        remains.length += static_cast<std::uint32_t>(text.size());
    };
    Player playing(options, writer);
    player = &playing;
    if (request.isText != 0) {
        playing.play(scriptOf(std::string(script.begin(), script.end())));
    } else {
        Draw draw(script.data(), script.size());
        playing.play(draw);
    }
    playing.finish();
    remains.hash = playing.hash();
    remains.workers = exactness::runningEngine().mostWorkers;
}

// The place in the source is not compared (contract C8).
std::string errorsOf(int file) {
    std::string text(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), '\0');
    if (pread(file, &text[0], text.size(), 0) < 0) return "";
    if (text.find('[') == std::string::npos) return text;
    static const std::regex place("\\[[^\\]]*:[0-9]+\\]");
    return std::regex_replace(text, place, "[file:line]");
}

void answer(const RequestHeader &request, const std::vector<std::uint8_t> &script, Remains &remains, int errors) {
    remains.hash = 0;
    remains.calls = remains.workers = remains.length = 0;
    if (ftruncate(errors, 0) != 0) _exit(1);
    lseek(errors, 0, SEEK_SET);
    const pid_t child = fork();
    if (child == 0) {
        dup2(errors, STDERR_FILENO);
        dup2(errors, STDOUT_FILENO);
        play(request, script, remains);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    const std::string errorText = errorsOf(errors);
    const AnswerHeader header{status,
                              remains.calls,
                              remains.hash,
                              remains.workers,
                              static_cast<std::uint32_t>(errorText.size()),
                              remains.length};
    writeAll(&header, sizeof header);
    writeAll(errorText.data(), errorText.size());
    writeAll(remains.text, remains.length);
}

int serve() {
    void *const shared = mmap(nullptr, sizeof(Remains), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    const int errors = memfd_create("errors", 0);
    if (shared == MAP_FAILED || errors < 0) return 1;
    functions();
    for (RequestHeader request; readAll(&request, sizeof request);) {
        std::vector<std::uint8_t> script(request.length);
        if (!readAll(script.data(), script.size())) return 1;
        answer(request, script, *static_cast<Remains *>(shared), errors);
    }
    return 0;
}

int show(const char *path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    Player::Options options;
    options.tells = true;
    options.jumps = text.str().find("# jumps") != std::string::npos;
    options.messages = text.str().find("# messages") != std::string::npos;
    Player player(options, [](const std::string &line) { std::cout << line << std::flush; });
    player.play(scriptOf(text.str()));
    player.finish();
    std::cout << "hash " << std::hex << player.hash() << std::endl;
    _exit(0);
}

}  // namespace

int main(int argc, char **argv) { return argc > 1 ? show(argv[1]) : serve(); }
