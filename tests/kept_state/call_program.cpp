// Calls exported functions of whatever libode.so.8 the loader finds, in many contexts, and prints a hash of
// what followed.
//
//   every_call --functions                        all names
//   every_call --run FILE [function]              one line for each case into FILE
//   every_call --show CASE                        everything that a case saw
//
// Each function has a process of its own: what it leaves behind in the library (colliders, classes) does not
// reach others, and a crash ends no more than its cases.
#include "call_contexts.h"
#include "user_code.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace {

using namespace kept_state;

constexpr int kShares = 2;

std::string play(const Case &c, bool show) {
    CallScene scene(c.kind, c.place, c.turn, show);
    scene.attempt([&] {
        prepare(scene, c);
        scene.frame();
        scene.frame();
        makeCall(scene, c);
        if (c.when != When::last) {
            for (int i = 0; i < 3; ++i) scene.frame();
            scene.tellState();
        }
        scene.destroy();
    });
    CallScene::living = nullptr;
    dSetAllocHandler(nullptr);
    const char *const remark = isCallWaiting() ? " not_reached" : "";
    forgetCall();
    if (show) std::printf("%s", scene.trace.text().c_str());
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(scene.trace.hash()));
    return std::string(text) + remark;
}

void startLibrary() {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
}

void append(int file, const std::string &text) {
    if (write(file, text.data(), text.size()) < 0) std::_Exit(3);
}

// Prints how many workers took part, and the number of prefetched contacts. Prints nothing on Debian's library.
std::string statistics() {
    const auto get = [](const char *name) {
        const auto function = reinterpret_cast<unsigned (*)()>(dlsym(RTLD_DEFAULT, name));
        return std::to_string(function == nullptr ? 0 : function());
    };
    return get("dODE_MT_GetMaxWorkersUsed") + ' ' + get("dODE_MT_GetContactsAhead") + ' ' +
           get("dODE_MT_GetParallelSteps");
}

// All cases of one function. The library is not closed: a case may have left half of something.
void runFunction(const CallRecipe &recipe, int number, int file) {
    startLibrary();
    forEachCase(recipe, number, [&](const Case &c) {
        append(file, c.name() + ' ');
        append(file, play(c, false) + '\n');
    });
    append(file, "statistics/" + recipe.function + ' ' + statistics() + '\n');
}

// Every kShares-th function, from `share` on.
void runShare(const std::string &path, int share, const std::string &only) {
    std::FILE *const out = std::fopen(path.c_str(), "w");
    if (out == nullptr) throw std::runtime_error("cannot write");
    int number = 0;
    for (const CallRecipe &recipe : callRecipes()) {
        ++number;
        if (number % kShares != share || (!only.empty() && recipe.function != only)) continue;
        const pid_t child = fork();
        if (child == 0) {
            alarm(60);
            runFunction(recipe, number, fileno(out));
            std::_Exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (status == 0) continue;
        std::string ending = WIFSIGNALED(status) ? std::string("ended by ") + strsignal(WTERMSIG(status))
                                                 : "exit status " + std::to_string(WEXITSTATUS(status));
        ending += '\n';
        std::fseek(out, 0, SEEK_END);
        std::fputs(ending.c_str(), out);
        std::fflush(out);
    }
    std::fclose(out);
}

// Shares run side by side, each into a file of its own.
void runAll(const std::string &path, const std::string &only) {
    const auto part = [&](int share) { return path + '.' + std::to_string(share); };
    pid_t children[kShares];
    for (int share = 0; share < kShares; ++share) {
        children[share] = fork();
        if (children[share] != 0) continue;
        runShare(part(share), share, only);
        std::_Exit(0);
    }
    std::ofstream out(path);
    for (int share = 0; share < kShares; ++share) {
        int status = 0;
        waitpid(children[share], &status, 0);
        if (status != 0) throw std::runtime_error("a share of the functions has failed");
        std::ifstream lines(part(share));
        for (std::string line; std::getline(lines, line);) out << line << '\n';
        std::remove(part(share).c_str());
    }
    if (!out.flush()) throw std::runtime_error("cannot write");
}

int show(const std::string &wanted) {
    int number = 0;
    startLibrary();
    for (const CallRecipe &recipe : callRecipes()) {
        ++number;
        if (wanted.rfind(recipe.function + '/', 0) != 0) continue;
        forEachCase(recipe, number, [&](const Case &c) {
            if (c.name() == wanted) std::printf("%s\n", play(c, true).c_str());
        });
    }
    return 0;
}

}  // namespace

int main(int argc, char **argv) {
    const std::string option = argc > 1 ? argv[1] : "";
    if (option == "--functions") {
        for (const CallRecipe &recipe : callRecipes()) std::printf("%s\n", recipe.function.c_str());
        return 0;
    }
    if (option == "--run" && argc > 2) {
        runAll(argv[2], argc > 3 ? argv[3] : "");
        return 0;
    }
    if (option == "--show" && argc > 2) return show(argv[2]);
    std::fprintf(stderr, "every_call --functions | --run FILE [function] | --show CASE\n");
    return 2;
}
