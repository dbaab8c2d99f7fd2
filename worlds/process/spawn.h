// Starts a program, with other variables and other standard files than ours.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace process {

// Variables on top of this process's; an empty value removes the variable.
using Environment = std::map<std::string, std::string>;

struct StandardFiles {
    int input = -1, output = -1, errors = -1;  // -1: this process's
};

// Own: the process leads a process group, so that signals reach whatever it starts, and its signals are as a shell gives them.
enum class Group { Ours, Own };

// The program, by its path or by its name in PATH, and its arguments. Throws std::runtime_error, which names the program, if it cannot
// be started.
pid_t spawn(const std::vector<std::string> &command, const Environment &changes, const StandardFiles &files, Group group = Group::Ours);

// "exit code 2", "signal 11 (Segmentation fault)". `status`: as waitpid gives it.
std::string endingOf(int status);

}  // namespace process
