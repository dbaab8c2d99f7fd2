// Makes every call with one bad argument at a time, each in a process of its own, and prints what came of it:
// the calls of handlers, and how the process ended. The first line names the library it runs on.
//
//   odemt_bad_input [PART OF A CALL'S NAME]
#include "bad_calls.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

using namespace bad_input;

// A call that computes for longer, or waits for longer, hangs. In seconds: of the processor, and by the
// clock, which also runs while other processes have the processor.
constexpr rlim_t kMaxComputing = 1;
constexpr unsigned kPatience = 60;
constexpr std::size_t kRoom = 1 << 14;
// The memory of a call: a bad argument may request as much as there is.
constexpr rlim_t kMaxMemory = rlim_t{2} << 30;

char *told;  // memory that a call's process shares with this one

void tell(const char *kind, int number, const char *format, va_list arguments) {
    char text[1024];
    std::vsnprintf(text, sizeof text, format, arguments);
    std::string line = text;
    for (char &c : line)
        if (c == '\n') c = ' ';
    const std::size_t used = std::strlen(told);
    std::snprintf(told + used, kRoom - used, " %s %d \"%s\"", kind, number, line.c_str());
}

void onMessage(int number, const char *format, va_list arguments) {
    tell("message", number, format, arguments);
}
void onDebug(int number, const char *format, va_list arguments) {
    tell("debug", number, format, arguments);
    _exit(0);
}
void onError(int number, const char *format, va_list arguments) {
    tell("error", number, format, arguments);
    _exit(0);
}

[[noreturn]] void makeInChild(const BadCall &call) {
    const rlimit noCore{0, 0}, memory{kMaxMemory, kMaxMemory},
        computing{kMaxComputing, kMaxComputing + 1};
    setrlimit(RLIMIT_CORE, &noCore);
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CPU, &computing);
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    alarm(kPatience);
    dSetMessageHandler(onMessage);
    dSetDebugHandler(onDebug);
    dSetErrorHandler(onError);
    try {
        call.make();
    } catch (const std::exception &) {
        _exit(2);
    }
    std::strcat(told, " returns");
    _exit(0);
}

std::string endingOf(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return signal == SIGALRM || signal == SIGXCPU ? " hangs" : " signal " + std::to_string(signal);
    }
    const int code = WEXITSTATUS(status);
    return code == 0 ? "" : code == 2 ? " throws" : " status " + std::to_string(code);
}

}  // namespace

int main(int count, char **arguments) {
    const std::string part = count > 1 ? arguments[1] : "";
    Dl_info library{};
    dladdr(reinterpret_cast<void *>(&dWorldStep), &library);
    std::printf("%s\n", library.dli_fname);
    told =
        static_cast<char *>(mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    dInitODE2(0);
    scene = new BadScene;
    for (const BadCall &call : badCalls()) {
        if (call.name.find(part) == std::string::npos) continue;
        *told = '\0';
        std::fflush(stdout);
        const pid_t child = fork();
        if (child == 0) makeInChild(call);
        int status = 0;
        waitpid(child, &status, 0);
        std::printf("%s:%s%s\n", call.name.c_str(), told, endingOf(status).c_str());
    }
    return 0;
}
