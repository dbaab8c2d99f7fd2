// odemt_check: whether a program computes the same on ODE_MT as on Debian's libode8.
#include "check/check_options.h"
#include "check/checker.h"
#include "support/deferred_signals.h"
#include "check/report.h"
#include "tool_output.h"
#include "support/orphans.h"

namespace {

int exitCodeOf(check::CheckResult::Verdict verdict) {
    using Verdict = check::CheckResult::Verdict;
    return verdict == Verdict::Equal ? check::kEqual : verdict == Verdict::Different ? check::kDifferent : check::kNotCompared;
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = check::readCheckOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    support::deferSignals();
    support::adoptOrphans();
    try {
        const check::CheckResult result = check::check(*options);
        bench::print(options->isJson ? reportJson(result) : reportText(result));
        return exitCodeOf(result.verdict);
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return check::kNotCompared;
    }
}
