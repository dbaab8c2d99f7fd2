// Draws command lines of the bench's programs, results and recordings for odemt_report among them, and checks how they
// end.
//
//   odemt_fuzz_options --seconds 300 --seed 1 --keep found
#include "driver/campaign.h"
#include "driver/message_text.h"
#include "support/temporary_folder.h"
#include "options/command_draw.h"
#include "options/recording_mutation.h"
#include "support/text_file.h"
#include "support/child_run.h"

#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <set>
#include <sstream>

namespace {

using namespace fuzz_options;
using support::Ending;
using fuzz_driver::Random;
using fuzz_driver::Verdict;

namespace fs = std::filesystem;

const char *const kWorld =
    "<sdf version=\"1.9\"><world name=\"w\"><model name=\"m\"><link name=\"l\"><collision "
    "name=\"c\"><geometry>"
    "<sphere><radius>1</radius></sphere></geometry></collision></link></model></world></sdf>\n";

const std::string kResults = R"({"machine":{"cores":2,"processor":"p"},"curves":[],"worlds":[{"world":"w","engines":[]}]})"
                             "\n";

class Fuzzer {
public:
    explicit Fuzzer(const fuzz_driver::CampaignOptions &options) : m_options(options) {
        fs::create_directories(work());
        for (const auto &[name, file] :
             {std::pair<std::string, std::string>{"odemt_bench", ODE_MT_FUZZ_BENCH},
              {"odemt_bench_child", ODE_MT_FUZZ_BENCH_CHILD},
              {"odemt_record", ODE_MT_FUZZ_RECORD},
              {"odemt_report", ODE_MT_FUZZ_REPORT}})
            m_programs.push_back({name, file, readOptionTable(execute(file, {"--help"}).output)});
        m_recording = execute(ODE_MT_FUZZ_RECORD, {"rover:1", "--frames", "3", "--every", "1"}).output;
        m_meshRecording =
            execute(ODE_MT_FUZZ_RECORD, {"mesh_terrain:1", "--frames", "2", "--algorithm", "static"}).output;
        if (m_recording.empty() || m_meshRecording.empty())
            throw std::runtime_error("odemt_record records nothing");
    }

    std::size_t countOfOptions() const {
        std::size_t count = 0;
        for (const Program &program : m_programs) count += program.options.size();
        return count;
    }

    Verdict play(std::uint64_t seed) {
        Random random(seed);
        const Program &program = random.of(m_programs);
        const Command command = drawCommand(program, random);
        prepare(random);
        const std::vector<std::string> before = filesIn(work());
        if (m_options.shows) std::cout << seed << ": " << command.text() << std::endl;
        const Ending ending = fuzz_options::run(command, work());
        std::string wrong = whatIsWrong(command, ending, work(), before);
        if (wrong.empty()) wrong = wrongOutput(program, command, ending);
        const std::string kind = program.name + ": " + ending.text();
        if (wrong.empty()) return {kind, ""};
        if (!m_options.keep.empty()) keep(seed, command);
        return {kind, wrong + "\n  " + command.text()};
    }

private:
    fs::path work() const { return m_folder.path() / "work"; }

    static Ending execute(const std::string &file, const std::vector<std::string> &arguments) {
        Command command;
        command.program = file;
        command.arguments = arguments;
        return fuzz_options::run(command, "/");
    }

    // The files that command lines name.
    void prepare(Random &random) const {
        fs::remove_all(work());
        support::writeTextFile(work() / "world.sdf", kWorld);
        support::writeTextFile(work() / "a,b.sdf", kWorld);
        support::writeTextFile(work() / "broken.sdf",
                               "<sdf version=\"1.9\"><world name=\"w\"><model/></world></sdf>");
        support::writeTextFile(work() / "kept", "of old\n");
        fs::create_symlink("kept", work() / "link");
        fs::create_symlink("nowhere", work() / "dangling");
        mkfifo((work() / "fifo.sdf").c_str(), 0600);
        const std::string &recording = random.oneIn(4) ? m_meshRecording : m_recording;
        support::writeTextFile(work() / kResultsFile, random.oneIn(5) ? kResults : mutatedLines(kResults, random));
        support::writeTextFile(work() / kRecordingFile,
                               random.oneIn(5) ? recording : mutatedLines(recording, random));
    }

    void keep(std::uint64_t seed, const Command &command) const {
        const fs::path folder = fs::path(m_options.keep) / std::to_string(seed);
        fs::create_directories(folder);
        for (const char *const file : {kRecordingFile, kResultsFile})
            fs::copy_file(work() / file, folder / file, fs::copy_options::overwrite_existing);
        support::writeTextFile(folder / "command", command.text() + "\n");
    }

    // A page has its end, an answer of the child is JSON.
    static std::string wrongOutput(const Program &program, const Command &command, const Ending &ending) {
        if (command.output != StandardFile::Kept || ending.output.empty()) return {};
        if (program.name == "odemt_bench_child" && ending.exitCode() < 2 && !isHelp(command))
            return wrongAnswers(ending.output);
        if (program.name != "odemt_report" || ending.output.compare(0, 9, "<!DOCTYPE") != 0) return {};
        const std::string end = "</html>\n";
        const bool isWhole = ending.output.size() > end.size() && ending.output.compare(ending.output.size() - end.size(), end.size(), end) == 0;
        return isWhole ? "" : "a page without its end";
    }

    static bool isHelp(const Command &command) {
        for (const std::string &argument : command.arguments)
            if (argument.rfind("--help", 0) == 0 || argument == "-h") return true;
        return false;
    }

    static std::string wrongAnswers(const std::string &output) {
        std::istringstream lines(output);
        for (std::string line; std::getline(lines, line);) {
            const auto answer = nlohmann::json::parse(line, nullptr, false);
            if (!answer.is_object() ||
                !(answer.contains("ready") || answer.contains("batch") || answer.contains("error")))
                return "an answer that the protocol has not: " + fuzz_driver::shown(line);
            if (!answer.contains("error")) continue;
            const std::string error = answer["error"].get<std::string>();
            if (const std::string wrong = fuzz_driver::whatIsNoPlainLine(error); !wrong.empty())
                return "an error that " + wrong + ": " + fuzz_driver::shown(error);
            if (const std::string name = fuzz_driver::innerNameIn(error); !name.empty())
                return "an error that names the inside: " + fuzz_driver::shown(error);
        }
        return {};
    }

    const fuzz_driver::CampaignOptions &m_options;
    const support::TemporaryFolder m_folder;
    std::vector<Program> m_programs;
    std::string m_recording, m_meshRecording;
};

}  // namespace

int main(int argc, char **argv) {
    fuzz_driver::CampaignOptions options;
    int exitCode = 0;
    if (!fuzz_driver::readCampaignOptions(argc, argv, "Runs drawn command lines.", options, nullptr,
                                          exitCode))
        return exitCode;
    try {
        fuzz_driver::setSanitizerOptions();
        Fuzzer fuzzer(options);
        std::cout << fuzzer.countOfOptions() << " options of 4 programs\n";
        return fuzz_driver::runCampaign(options, "command lines",
                                        [&](std::uint64_t seed) { return fuzzer.play(seed); });
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz_options: " << error.what() << '\n';
        return 2;
    }
}
