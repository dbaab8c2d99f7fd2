#include "playing.h"

#include <sys/wait.h>

#include <csignal>

namespace fuzz {

std::string Outcome::ending() const {
    return WIFSIGNALED(header.ending) ? "signal " + std::to_string(WTERMSIG(header.ending))
                                      : "exit status " + std::to_string(WEXITSTATUS(header.ending));
}

bool Outcome::endedInTime() const {
    if (!WIFSIGNALED(header.ending)) return true;
    const int signal = WTERMSIG(header.ending);
    return signal != SIGALRM && signal != SIGXCPU;
}

bool Outcome::crashed() const {
    if (!WIFSIGNALED(header.ending)) return false;
    const int signal = WTERMSIG(header.ending);
    return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL || signal == SIGKILL;
}

}  // namespace fuzz
