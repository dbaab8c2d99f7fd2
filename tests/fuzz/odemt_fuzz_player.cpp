// Plays scripts on the libode.so.8 that the loader finds, each in a process of its own: requests on standard input, answers on
// standard output (protocol.h). `odemt_fuzz_player FILE` plays a script as text and prints what it sees;
// `odemt_fuzz_player --functions` prints the names of the functions that scripts call. Before all others, `--fast` and `--fast-serial`
// say as what it plays (played_as.h); ODE_MT_SOLVER chooses the solver.
#include "forked_play.h"
#include "function.h"
#include "played_as.h"
#include "player.h"

#include <ode/ode.h>

#include <unistd.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

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

int serve() {
    ForkedPlay play;
    for (RequestHeader request; readAll(&request, sizeof request);) {
        std::vector<std::uint8_t> script(request.length);
        if (!readAll(script.data(), script.size())) return 1;
        play.ask(request, script);
        const Outcome outcome = play.answer();
        writeAll(&outcome.header, sizeof outcome.header);
        writeAll(outcome.errors.data(), outcome.errors.size());
        writeAll(outcome.text.data(), outcome.text.size());
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

int listFunctions() {
    for (const Function &function : functions()) std::cout << function.name << '\n';
    return 0;
}

}  // namespace

int main(int argc, char **argv) {
    try {
        if (argc == 1) return serve();
        const std::string option = argv[1];
        playedAs.isSerial = option == "--fast-serial";
        playedAs.isFast = playedAs.isSerial || option == "--fast";
        if (playedAs.isFast) return argc == 2 ? serve() : show(argv[2]);
        return option == "--functions" ? listFunctions() : show(argv[1]);
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz_player: " << error.what() << '\n';
        return 1;
    }
}
