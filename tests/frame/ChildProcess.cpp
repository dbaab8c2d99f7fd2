#include "ChildProcess.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

namespace {

constexpr unsigned kLimit = 20;  // s

std::string readAll(int file) {
    std::string text;
    char buffer[4096];
    for (ssize_t got; (got = read(file, buffer, sizeof buffer)) > 0;) text.append(buffer, got);
    return text;
}

}  // namespace

bool ChildEnd::exitedWith(int code) const { return WIFEXITED(status) && WEXITSTATUS(status) == code; }

bool ChildEnd::killedBy(int signal) const { return WIFSIGNALED(status) && WTERMSIG(status) == signal; }

ChildEnd runInChild(const std::function<void()> &function) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        alarm(kLimit);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        function();
        std::fflush(nullptr);
        _exit(0);
    }
    close(ends[1]);
    ChildEnd end;
    end.errors = readAll(ends[0]);
    close(ends[0]);
    EXPECT_EQ(waitpid(child, &end.status, 0), child);
    return end;
}

bool trueInChild(const std::function<bool()> &function) {
    const ChildEnd end = runInChild([&] {
        if (!function()) _exit(1);
    });
    if (!end.errors.empty()) std::fputs(end.errors.c_str(), stderr);
    return end.exitedWith(0);
}
