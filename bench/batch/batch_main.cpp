// odemt_batch: many worlds into one table (docs/tools.md). Under mpirun it becomes odemt_batch_mpi, which lies beside it: this program needs no MPI.
#include "batch/batch_options.h"
#include "batch/master.h"
#include "batch/workers.h"
#include "tool_output.h"
#include "library_folders.h"
#include "support/text_file.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace {

// As the launchers of OpenMPI, of MPICH and its relatives say.
bool isOneOfSeveralRanks() {
    for (const char *const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE"}) {
        const char *const size = std::getenv(name);
        if (size != nullptr && std::atol(size) > 1) return true;
    }
    return false;
}

[[noreturn]] void becomeRank(char **argv) {
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "odemt_batch_mpi";
    execv(program.c_str(), argv);
    throw std::runtime_error("is one of several ranks of MPI, for which there is no " + program.string() + " (docs/tools.md)");
}

void list(const batch::Plan &plan) {
    for (long number = 0; number < plan.count(); ++number) {
        const batch::Run run = plan.run(number);
        batch::Json line = {{"run", number}, {"world", run.world}};
        for (const auto &[name, value] : run.values) line[name] = value;
        line["seed"] = run.seed;
        bench::print(line.dump() + "\n");
    }
}

// Returns the exit code: 1 if a run has failed.
int runBatch(const batch::BatchOptions &options) {
    const batch::Plan plan = batch::readPlan(support::readTextFile(options.planFile));
    if (options.lists) {
        list(plan);
        return 0;
    }
    batch::checkWorlds(plan);
    batch::Workers workers(plan, options.workers);
    batch::Store store(options.output, plan, options.isResumed ? batch::Store::Begin::Resumed : batch::Store::Begin::New);
    batch::runPlan(plan, store, workers, nullptr, options.isQuiet);
    const int exitCode = batch::exitCodeOf(store);
    store.close();
    return exitCode;
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    try {
        if (isOneOfSeveralRanks()) becomeRank(argv);
        const auto options = batch::readBatchOptions(argc, argv, exitCode);
        if (!options) return bench::exitCodeAfterOutput(exitCode);
        for (const std::string &name : bench::libraryVariables()) unsetenv(name.c_str());  // the plan says all that results depend on
        return runBatch(*options);
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return 1;
    }
}
