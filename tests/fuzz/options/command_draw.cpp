#include "options/command_draw.h"

#include "driver/drawn_text.h"
#include "options/recording_mutation.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace fuzz_options {

namespace {

using fuzz_driver::Random;
using Values = std::vector<std::string>;

// What is right for an option, or nearly so.
const std::map<std::string, Values> &knownValues() {
    static const Values worlds = {"rover:1",
                                  "rover:2",
                                  "stacks:2",
                                  "spheres:3,quick",
                                  "wall:2",
                                  "rover:1..2",
                                  "rover",
                                  "world.sdf",
                                  "rover:0",
                                  "rover:-1",
                                  "rover:",
                                  "rover:1,quick,quick",
                                  "rover:1,nosuch",
                                  "nosuch",
                                  "nosuch:3",
                                  "rover:99999999999999999999",
                                  "world.sdf:3",
                                  "world.sdf,static_meets_static",
                                  "world.sdf:nan",
                                  "rover:1..",
                                  "rover:2..1",
                                  "a\\,b.sdf",
                                  ",",
                                  "rover:1,,",
                                  "thesis,quick",
                                  "chain:1e3",
                                  "pile:4,sap",
                                  "stacks:2,hash",
                                  "./",
                                  "/",
                                  "broken.sdf",
                                  "fifo.sdf",
                                  "rover:1, rover:1"};
    static const Values files = {
        "a.json", "b.csv",    "new/c.json", "kept",       "world.sdf", "recording.json",
        "",       ".",        "new/",       "/dev/null",  "/dev/full", "/dev/stdout",
        "link",   "dangling", "fifo.sdf",   "kept/below", "a\nb",      "\x1b[31m.json"};
    static const Values threads = {"0",  "1",   "2", "0,1,2", "auto", "1024", "1025",
                                   "-1", "2,2", "",  ",",     "1,",   "01",   "0x1"};
    static const std::map<std::string, Values> values = {
        {"--worlds", worlds},
        {"--world", worlds},
        {"world", worlds},
        {"--engines",
         {"stock",
          "ours",
          "ours:0",
          "ours:2",
          "stock,ours:2",
          "ours:2/openmp",
          "ours:1/lcp/concurrent",
          "ours:2/cells=7",
          "stock-pool:1",
          "stock-pool",
          "ours:2/",
          "ours:",
          "ours:2/cells=",
          "stock:1",
          "stock:/nowhere/libode.so.8",
          "stock:/usr/lib/x86_64-linux-gnu,ours:2",
          "stock:kept",
          "ours:2/openmp/pthread",
          "nosuch",
          "ours,ours",
          "",
          "stock/x",
          "ours:2//lcp",
          "stock-pool:0"}},
        {"--threads", threads},
        {"--manager", {"pthread", "openmp", "none", "", "PTHREAD", "pthread,openmp"}},
        {"--json", files},
        {"--csv", files},
        {"--samples", files},
        {"--trace", files},
        {"--output", files},
        {"--stock-library", {"/usr/lib/x86_64-linux-gnu", "/nowhere", "", ".", "kept", "/dev/null"}},
        {"--our-library", {"/nowhere", "", ".", "kept"}},
        {"--algorithm",
         {"original", "static", "static-unmerged", "duplication", "decluster", "lcp", "auto", ""}},
        {"--cells", {"0", "4", "5", "20", "21", "-5", "5.0"}},
        {"results", {kResultsFile, kResultsFile, kResultsFile, kRecordingFile, "nosuch.json", ".", "world.sdf", "/dev/null", ""}},
        {"--recording",
         {kRecordingFile, kRecordingFile, kRecordingFile, kRecordingFile, kRecordingFile, kRecordingFile,
          "nosuch.json", "new", ".", "world.sdf", "/dev/null", ""}},
        {"--pool", {"0", "1", "2", "-1", "4294967295", "4294967296", "100000"}}};
    return values;
}

bool isOutput(const std::string &option) {
    return option == "--json" || option == "--csv" || option == "--samples" || option == "--html" || option == "--trace" ||
           option == "--output";
}

// Those that say how long a run takes: what they may be at most.
const std::map<std::string, double> &largest() {
    static const std::map<std::string, double> values = {{"--seconds", 0.2}, {"--frames", 20},
                                                         {"--warm-up", 20},  {"--warm-up-seconds", 0.2},
                                                         {"--timeout", 1e6}, {"--pool", 1e9}};
    return values;
}

bool takesLong(const std::string &option, const std::string &value) {
    const auto most = largest().find(option);
    double number = 0;
    const auto result = std::from_chars(value.data(), value.data() + value.size(), number);
    return most != largest().end() && result.ec == std::errc() && number > most->second && number <= 1e9;
}

// Drawn text names no file outside of the folder.
std::string withoutFolders(std::string text) {
    std::replace(text.begin(), text.end(), '/', '_');
    return text == ".." || text == "~" ? "x" : text;
}

std::string drawValue(const Option &option, Random &random) {
    const auto known = knownValues().find(option.name);
    if (known != knownValues().end() && !random.oneIn(5)) return random.of(known->second);
    if (!option.choices.empty() && random.oneIn(2)) return random.of(option.choices);
    const bool isNumber = option.type == "INT" || option.type == "FLOAT" || option.type == "UINT";
    const std::string value =
        isNumber && !random.oneIn(5)
            ? (random.oneIn(2) ? std::to_string(random.below(12)) : fuzz_driver::drawNumber(random))
            : withoutFolders(fuzz_driver::drawText(random));
    return takesLong(option.name, value) ? "2" : value;
}

// Besides "--frames 2" it draws "--frames=2", an empty value, and none.
void append(Command &command, const Option &option, const std::string &value, Random &random) {
    if (option.isPositional) {
        command.arguments.push_back(value);
    } else if (option.type.empty()) {
        command.arguments.push_back(random.oneIn(12) ? option.name + "=" + value : option.name);
    } else if (random.oneIn(4)) {
        command.arguments.push_back(option.name + "=" + value);
    } else {
        command.arguments.push_back(option.name);
        if (!random.oneIn(40)) command.arguments.push_back(value);
    }
    if (isOutput(option.name)) command.results.push_back(value);
}

bool isGiven(const Command &command, const std::string &option) {
    return std::any_of(command.arguments.begin(), command.arguments.end(), [&](const std::string &argument) {
        return argument == option || argument.rfind(option + "=", 0) == 0;
    });
}

// What is said of time by default is too long.
void limitTime(const Program &program, Command &command) {
    const auto add = [&](const std::string &option, const std::string &value) {
        const bool isKnown = std::any_of(program.options.begin(), program.options.end(),
                                         [&](const Option &known) { return known.name == option; });
        if (isKnown && !isGiven(command, option))
            command.arguments.insert(command.arguments.end(), {option, value});
    };
    add("--frames", "3");
    if (program.name != "odemt_bench") return;
    add("--seconds", "0.02");
    add("--warm-up", "1");
    add("--warm-up-seconds", "0.02");
    add("--worlds", "rover:1");
    add("--engines", "ours:0");
    for (const char *const option : {"--json", "--csv"}) {
        if (isGiven(command, option)) continue;
        command.results.push_back(std::string("results/bench.") + (option + 2));
    }
}

void drawSurroundings(Command &command, Random &random) {
    static const Values locales = {"C", "C.UTF-8", "POSIX", "de_DE.UTF-8", "tr_TR", "", "nosuch", "../x"};
    if (random.oneIn(3)) command.environment["LC_ALL"] = random.of(locales);
    if (random.oneIn(6))
        command.environment["ODE_MT_WORLDS"] =
            random.oneIn(2) ? "/nowhere" : withoutFolders(fuzz_driver::drawGarbage(random));
    if (random.oneIn(6)) command.environment["COLUMNS"] = fuzz_driver::drawNumber(random);
    command.closesInput = random.oneIn(8);
    static const std::vector<StandardFile> files = {
        StandardFile::Kept, StandardFile::Kept, StandardFile::Kept,   StandardFile::Kept,
        StandardFile::Kept, StandardFile::Kept, StandardFile::Closed, StandardFile::Full};
    command.output = random.of(files);
    command.errors = random.oneIn(3) ? random.of(files) : StandardFile::Kept;
}

// Requests for odemt_bench_child.
std::string drawInput(Random &random) {
    std::string lines;
    for (std::size_t i = random.below(4); i > 0; --i)
        lines += "{\"frames\":" + std::to_string(random.below(4)) + "}\n";
    std::string changed = random.oneIn(2) ? mutatedLines(lines, random) : lines;
    // Numbers with three zeros or large exponents would be too many frames.
    return changed.find("000") != std::string::npos || changed.find("e") == std::string::npos ||
                   changed.find_first_of("56789") != std::string::npos
               ? lines
               : changed;
}

}  // namespace

Command drawCommand(const Program &program, Random &random) {
    Command command;
    command.program = program.file;
    const std::size_t most = 1 + random.below(random.oneIn(4) ? 12 : 4);
    for (const Option &option : program.options) {
        const bool isNeeded = option.isPositional || option.name == "--world" || option.name == "--output";
        if (isNeeded && !random.oneIn(20)) append(command, option, drawValue(option, random), random);
    }
    for (std::size_t i = 0; i < most; ++i) {
        const Option &option = random.of(program.options);
        if (option.name == "--help" && !random.oneIn(5)) continue;
        if (isGiven(command, option.name) && !random.oneIn(20)) continue;
        append(command, option, drawValue(option, random), random);
    }
    if (random.oneIn(15)) command.arguments.push_back(withoutFolders(fuzz_driver::drawText(random)));
    limitTime(program, command);
    for (std::string &argument : command.arguments)
        argument.erase(std::remove(argument.begin(), argument.end(), '\0'), argument.end());
    drawSurroundings(command, random);
    if (program.name == "odemt_bench_child") command.input = drawInput(random);
    return command;
}

}  // namespace fuzz_options
