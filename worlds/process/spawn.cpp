#include "process/spawn.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <stdexcept>

extern char **environ;

namespace process {

namespace {

std::vector<std::string> changedEnvironment(const Environment &changes) {
    std::vector<std::string> result;
    for (char **entry = environ; *entry != nullptr; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        if (changes.count(name) == 0) result.emplace_back(*entry);
    }
    for (const auto &[name, value] : changes)
        if (!value.empty()) result.push_back(name + '=' + value);
    return result;
}

std::vector<char *> pointers(std::vector<std::string> &strings) {
    std::vector<char *> result;
    for (std::string &string : strings) result.push_back(string.data());
    result.push_back(nullptr);
    return result;
}

void leadGroup(posix_spawnattr_t &attributes) {
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
}

}  // namespace

pid_t spawn(const std::vector<std::string> &command, const Environment &changes, const StandardFiles &files, Group group) {
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (group == Group::Own) leadGroup(attributes);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const auto give = [&](int file, int standardFile) {
        if (file >= 0) posix_spawn_file_actions_adddup2(&actions, file, standardFile);
    };
    give(files.input, STDIN_FILENO);
    give(files.output, STDOUT_FILENO);
    give(files.errors, STDERR_FILENO);
    std::vector<std::string> arguments = command, environment = changedEnvironment(changes);
    pid_t child = -1;
    const int error = posix_spawnp(&child, command[0].c_str(), &actions, &attributes, pointers(arguments).data(),
                                   pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw std::runtime_error("cannot start " + command[0] + ": " + std::strerror(error));
    return child;
}

std::string endingOf(int status) {
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    const int number = WTERMSIG(status);
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
}

}  // namespace process
