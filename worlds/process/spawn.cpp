#include "process/spawn.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

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

}  // namespace

pid_t spawn(const std::vector<std::string> &command, const Environment &changes, const StandardFiles &files) {
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
    const int error = posix_spawn(&child, command[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot start " + command[0] + ": " + std::strerror(error));
    return child;
}

std::string endingOf(int status) {
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    const int number = WTERMSIG(status);
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
}

}  // namespace process
