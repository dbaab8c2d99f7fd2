// Calls exported functions of whatever libode.so.8 the loader finds, in many contexts, and prints a hash of
// what followed.
//
//   every_call --functions                        all names
//   every_call --run FILE [--only function]       one line for each case and stage into FILE
//   every_call --show CASE                        everything that a case saw
//
// Each function has a process of its own: what it leaves behind in the library (colliders, classes) does not
// reach others, and a crash ends no more than its cases.
#include "call_recipes.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace {

using namespace kept_state;

enum class When { between, asked, beforeStep, near, nearOther, moved, twice, undone, last };
constexpr When allWhens[] = {When::between, When::asked, When::beforeStep, When::near, When::nearOther,
                             When::moved,   When::twice, When::undone,     When::last};

const char *nameOf(When when) {
    static const char *const names[] = {"between", "asked", "before_step", "near", "near_other",
                                        "moved",   "twice", "undone",      "last"};
    return names[static_cast<int>(when)];
}

struct Case {
    const CallRecipe &recipe;
    When when;
    SpaceKind kind;
    Place place;
    int turn;

    std::string name() const {
        return recipe.function + '/' + nameOf(when) + '/' + kept_state::nameOf(kind) + '/' +
               kept_state::nameOf(place) + '/' + std::to_string(turn);
    }
};

void makeCall(CallScene &scene, const Case &c) {
    const auto call = [&] { c.recipe.call(scene); };
    const auto attempt = [&] { scene.attempt(call); };
    switch (c.when) {
        case When::between:
            return attempt();
        case When::asked:
            scene.askBoxes();
            return attempt();
        case When::beforeStep:
            scene.collide();
            scene.attempt(call);
            return scene.step();
        case When::near:
        case When::nearOther:
            scene.inNearCallback = call;
            return scene.frame();
        case When::moved:
            scene.inMovedCallback = call;
            return scene.frame();
        case When::twice:
            scene.attempt(call);
            return attempt();
        case When::undone:
            scene.attempt(call);
            scene.attempt([&] { c.recipe.undo(scene); });
            return;
        case When::last:
            scene.askBoxes();
            return attempt();
    }
}

std::string play(const Case &c, bool show) {
    CallScene scene(c.kind, c.place, c.turn, show);
    scene.attempt([&] {
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
    if (show) std::printf("%s", scene.trace.text().c_str());
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(scene.trace.hash()));
    return text;
}

// Kinds of spaces, and places within them, by turns. ODE_MT_EXACTNESS=thorough: all of them.
template <class Visit>
void forEachCase(const CallRecipe &recipe, int number, Visit visit) {
    const char *const wanted = std::getenv("ODE_MT_EXACTNESS");
    const bool thorough = wanted != nullptr && std::strcmp(wanted, "thorough") == 0;
    for (const When when : allWhens) {
        if (when == When::undone && !recipe.undo) continue;
        if (recipe.readsOnly && when != When::asked && when != When::near) continue;
        if (when == When::near && !recipe.inLocked) continue;
        if (when == When::moved && !recipe.inStep) continue;
        for (const SpaceKind kind : allSpaceKinds) {
            if (!thorough && !recipe.everySpace &&
                (number + static_cast<int>(when) + static_cast<int>(kind)) % 2 != 0)
                continue;
            if (recipe.anySpace && (number + static_cast<int>(when) + static_cast<int>(kind)) % 4 != 0)
                continue;
            for (int p = 0; p < 4; ++p) {
                if (!thorough && (p + number + static_cast<int>(when) + static_cast<int>(kind)) % 4 != 0)
                    continue;
                Place place = allPlaces[p];
                if (when == When::nearOther) place = Place::other;
                const int turn = number + 5 * static_cast<int>(when) + 3 * static_cast<int>(kind) + 7 * p;
                visit(Case{recipe, when, kind, place, turn});
            }
        }
    }
}

void startLibrary() {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
}

// All cases of one function. The library is not closed: a case may have left half of something.
void runFunction(const CallRecipe &recipe, int number, int file) {
    startLibrary();
    forEachCase(recipe, number, [&](const Case &c) {
        const std::string name = c.name() + ' ';
        if (write(file, name.data(), name.size()) < 0) std::_Exit(3);
        const std::string hash = play(c, false) + '\n';
        if (write(file, hash.data(), hash.size()) < 0) std::_Exit(3);
    });
}

void runAll(const char *path, const std::string &only) {
    std::FILE *const out = std::fopen(path, "w");
    if (out == nullptr) throw std::runtime_error("cannot write");
    int number = 0;
    for (const CallRecipe &recipe : callRecipes()) {
        ++number;
        if (!only.empty() && recipe.function != only) continue;
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
