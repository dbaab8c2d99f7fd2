#include "unset_memory.h"

#include "support/child_run.h"
#include "support/temporary_folder.h"
#include "support/text_file.h"

#include <unistd.h>

#include <cstdlib>

namespace fuzz {

bool readsUnsetMemory(const std::string &player, const std::string &libraryFolder, const std::string &text) {
    constexpr int kFound = 77;
    const support::TemporaryFolder folder;
    const std::string script = (folder.path() / "script").string();
    support::writeTextFile(script, text);
    support::Limits limits;
    limits.seconds = 600;
    limits.cpuSeconds = 300;
    limits.memory = std::size_t{4} << 30;
    const auto work = [&]() -> int {
        setenv("LD_LIBRARY_PATH", libraryFolder.c_str(), 1);
        execlp("valgrind", "valgrind", "-q", ("--error-exitcode=" + std::to_string(kFound)).c_str(), "--exit-on-first-error=yes",
               player.c_str(), script.c_str(), static_cast<char *>(nullptr));
        return 127;
    };
    const support::Ending ending = support::runFunction(work, limits);
    return ending.exited() && ending.exitCode() == kFound;
}

}  // namespace fuzz
