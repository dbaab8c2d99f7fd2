#include "batch/world_check.h"

#include "batch/world_run.h"
#include "support/text_file.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <stdexcept>

namespace batch {

namespace {

constexpr int kIsWrong = 1;  // exit code of the process that has written why

void endQuietly(int, const char *, va_list) { _exit(0); }  // the run says it

[[noreturn]] void tryWorlds(const Plan &plan, std::size_t first, int answer) {
    initialiseOde(endQuietly);
    const long runsOfAWorld = plan.count() / static_cast<long>(plan.worlds.size());
    for (std::size_t world = first; world < plan.worlds.size(); ++world) {
        const Run run = plan.run(static_cast<long>(world) * runsOfAWorld);
        support::writeAll(answer, std::string(1, '\0'));  // begins with this one
        try {
            tryWorld(plan, run);
        } catch (const std::exception &error) {
            support::writeAll(answer, std::string(error.what()) + " (run " + std::to_string(run.number) + ", world '" + run.world + "')");
            _exit(kIsWrong);
        }
    }
    _exit(0);
}

std::string readAll(int file) {
    std::string text;
    char bytes[4096];
    for (ssize_t count; (count = read(file, bytes, sizeof bytes)) > 0 || (count < 0 && errno == EINTR);)
        if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
    return text;
}

}  // namespace

void checkWorlds(const Plan &plan) {
    for (std::size_t first = 0; first < plan.worlds.size();) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
        const pid_t child = support::forkChild();
        if (child == 0) {
            close(ends[0]);
            tryWorlds(plan, first, ends[1]);
        }
        close(ends[1]);
        std::string text = child > 0 ? readAll(ends[0]) : std::string();
        close(ends[0]);
        if (child < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        if (WIFEXITED(status) && WEXITSTATUS(status) == kIsWrong) throw std::runtime_error(text.substr(text.rfind('\0') + 1));
        // Behind one that has ended the process, if it has.
        first += std::max<std::size_t>(1, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\0')));
    }
}

}  // namespace batch
