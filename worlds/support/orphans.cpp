#include "support/orphans.h"

#include <dirent.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace support {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kPolite = 1s;  // for what SIGTERM makes a process do
constexpr auto kForced = 3s;

// As /proc/PROCESS/stat has them behind the name, which may hold anything.
struct Status {
    char state = 'Z';
    pid_t parent = -1;
};

Status statusOf(const std::string &process) {
    const std::string text = readWhatIsThere("/proc/" + process + "/stat");
    Status status;
    if (const std::size_t name = text.rfind(')'); name != std::string::npos)
        std::istringstream(text.substr(name + 1)) >> status.state >> status.parent;
    return status;
}

struct Child {
    pid_t process;
    bool isRunning;  // else it has just ended, or its first thread has, which looks the same
};

// /proc/self/task/PID/children would be the shorter way, where the kernel is built with it.
std::vector<Child> childrenOfThis() {
    std::vector<Child> children;
    DIR *const processes = opendir("/proc");
    if (processes == nullptr) return children;
    const pid_t self = getpid();
    while (const dirent *const entry = readdir(processes)) {
        if (entry->d_name[0] < '1' || entry->d_name[0] > '9') continue;
        const Status status = statusOf(entry->d_name);
        if (status.parent == self) children.push_back({std::atoi(entry->d_name), status.state != 'Z'});
    }
    closedir(processes);
    return children;
}

}  // namespace

void adoptOrphans() { prctl(PR_SET_CHILD_SUBREAPER, 1); }

void reapOrphans() {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
}

EndedOrphans endOrphans(const std::function<void(std::chrono::milliseconds)> &wait) {
    EndedOrphans ended;
    std::set<pid_t> asked;
    const Clock::time_point begin = Clock::now();
    for (;;) {
        reapOrphans();
        const std::vector<Child> children = childrenOfThis();
        if (children.empty()) return ended;
        for (const Child &child : children) ended.wereThere = ended.wereThere || child.isRunning;
        const auto passed = Clock::now() - begin;
        if (passed > kPolite + kForced) {
            ended.areLeft = true;
            return ended;
        }
        const bool isForced = passed > kPolite;
        for (const Child &child : children)
            if (isForced || asked.insert(child.process).second) kill(child.process, isForced ? SIGKILL : SIGTERM);
        wait(isForced ? 1ms : 10ms);
    }
}

}  // namespace support
