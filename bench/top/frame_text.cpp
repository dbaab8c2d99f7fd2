#include "top/frame_text.h"

#include <cstdarg>
#include <cstdio>

#include "settings/dxSerialReason.h"
#include "serial_share.h"
#include "support/text.h"
#include "table.h"

namespace top {

namespace {

constexpr double kMinShown = 0.005;  // a smaller part would be 0 %

__attribute__((format(printf, 1, 2))) std::string print(const char *format, ...) {
    char text[400];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::string milliseconds(double seconds) { return print("%.3f", 1e3 * seconds); }

std::string percent(double part) { return print("%.0f %%", 100 * part); }

std::string parts(double whole, const std::vector<std::pair<const char *, double>> &named) {
    std::string text = milliseconds(whole) + " ms";
    const char *before = ": ";
    for (const auto &[name, seconds] : named) {
        if (seconds <= 0) continue;
        text += before + print("%s %s", name, milliseconds(seconds).c_str());
        before = ", ";
    }
    return text;
}

std::string why(const char *what, unsigned threads, int reason, double parallel) {
    const std::string often = parallel >= kMinShown ? print(" (on several in %.0f %%)", 100 * parallel) : "";
    if (reason == dODE_MT_REASON_PARALLEL) return print("%s: %u threads", what, threads) + often;
    return print("%s: one thread, as %s", what, dxTextOfReason(reason)) + often;
}

// Of the islands: those that workers in other processes have solved, or should have.
std::string elsewhere(const dODE_MT_WorldStatistics &last) {
    const std::string lost = last.remoteWorkersLost != 0 ? print(", %u lost", last.remoteWorkersLost) : "";
    return print("remote workers: %u%s; solved %u islands, %u more at home after all (of all frames %llu, %llu)", last.remoteWorkers, lost.c_str(),
                 last.remoteIslands, last.returnedIslands, last.allRemoteIslands, last.allReturnedIslands);
}

}  // namespace

const char *const kNoWorld =
    "No world was seen to be stepped. Not seen are programs that take another library than LD_LIBRARY_PATH names (RPATH, LD_PRELOAD, linked "
    "statically), or are started "
    "with an emptied environment (env -i)";

std::vector<std::string> tableOf(const std::vector<FrameRates> &worlds) {
    using Column = bench::Table::Column;
    bench::Table table({Column{"world"}, Column{"process"}, Column{"frames"}, Column{"a second"}, Column{"frame ms"}, Column{"collide ms"},
                        Column{"step ms"}, Column{"bodies"}, Column{"pairs"}, Column{"hits"}, Column{"islands"}, Column{"rows"},
                        Column{"threads"}});
    for (const FrameRates &rates : worlds) {
        const dODE_MT_WorldStatistics &last = rates.world.statistics;
        table.addRow({std::to_string(last.number), std::to_string(rates.world.process), std::to_string(last.frames), print("%.1f", rates.perSecond),
                      milliseconds(rates.frame), milliseconds(rates.collision), milliseconds(rates.step), std::to_string(last.bodies),
                      std::to_string(last.pairs), last.contactsAhead != 0 ? percent(last.hitRate) : "-", std::to_string(last.islands),
                      std::to_string(last.rows), print("%u+%u", last.collisionThreads, last.stepThreads)});
    }
    return support::split(table.text(), '\n');
}

std::vector<std::string> detailsOf(const FrameRates &rates) {
    const dODE_MT_WorldStatistics &last = rates.world.statistics;
    std::vector<std::string> lines;
    lines.push_back(print("world %u, last frame: %u bodies, %u contacts, %u threads at most%s", last.number, last.bodies, last.contacts,
                          last.threads > 1 ? last.threads : 1, rates.world.hasEnded ? "; it has ended" : ""));
    if (last.collisions != 0) {
        lines.push_back("  collide  " + parts(last.collisionTime, {{"broad phase", last.broadPhaseTime},
                                                                  {"near-callbacks", last.callbackTime},
                                                                  {"narrow-phase prefetch in them", last.prefetchTime}}));
        const bool isOneReason = last.collisionReason == last.callbackReason;
        lines.push_back("           " + why(isOneReason ? "pairs and near-callbacks" : "pairs", last.collisionThreads, last.collisionReason,
                                            rates.parallelCollisions));
        if (!isOneReason) lines.push_back("           " + why("near-callbacks", last.collisionThreads, last.callbackReason, 0));
    }
    lines.push_back("  step     " + parts(last.stepTime, {{"island search", last.islandSearchTime},
                                                         {"preparation", last.islandPreparationTime},
                                                         {"islands", last.islandsTime},
                                                         {"commit", last.commitTime}}));
    lines.push_back("           " + why("islands", last.stepThreads, last.stepReason, rates.parallelSteps));
    if (last.remoteWorkers + last.remoteWorkersLost > 0 || last.allRemoteIslands + last.allReturnedIslands > 0)
        lines.push_back("           " + elsewhere(last));
    if (last.workTime > 0) lines.push_back("  share    " + bench::gainText(last.serialShare));
    if (last.waitTime > 0) lines.push_back("  waiting  " + milliseconds(last.waitTime) + " ms for other threads");
    return lines;
}

std::string textOf(const std::vector<FrameRates> &worlds, unsigned long long refused) {
    if (worlds.empty()) return std::string(kNoWorld) + '\n';
    std::string text;
    for (const std::string &line : tableOf(worlds)) text += line + '\n';
    for (const FrameRates &rates : worlds)
        for (const std::string &line : detailsOf(rates)) text += line + '\n';
    if (refused != 0) text += print("%llu further worlds are not shown\n", refused);
    return text;
}

}  // namespace top
