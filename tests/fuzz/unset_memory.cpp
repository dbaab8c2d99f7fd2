#include "unset_memory.h"

#include "driver/limited_run.h"
#include "driver/temporary_folder.h"

#include <unistd.h>

#include <cstdlib>

namespace fuzz {

bool readsUnsetMemory(const std::string &player, const std::string &libraryFolder, const std::string &text) {
    constexpr int kFound = 77;
    const fuzz_driver::TemporaryFolder folder;
    const std::string script = (folder.path() / "script").string();
    fuzz_driver::writeFile(script, text);
    fuzz_driver::Limits limits;
    limits.seconds = 600;
    limits.cpuSeconds = 300;
    limits.memory = std::size_t{4} << 30;
    const auto work = [&]() -> int {
        setenv("LD_LIBRARY_PATH", libraryFolder.c_str(), 1);
        execlp("valgrind", "valgrind", "-q", ("--error-exitcode=" + std::to_string(kFound)).c_str(), "--exit-on-first-error=yes",
               player.c_str(), script.c_str(), static_cast<char *>(nullptr));
        return 127;
    };
    const fuzz_driver::Ending ending = fuzz_driver::runLimited(work, limits);
    return ending.exited() && ending.exitCode() == kFound;
}

}  // namespace fuzz
