#include "options/tool.h"

#include "driver/message_text.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace fuzz_options {

namespace fs = std::filesystem;
using support::Ending;

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kMemory = std::size_t{3} << 30;  // bytes
#else
constexpr std::size_t kMemory = std::size_t{1} << 30;
#endif

std::string quoted(const std::string &word) {
    if (!word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./:,") ==
            std::string::npos)
        return word;
    return "'" + fuzz_driver::shown(word, 200) + "'";
}

void setStandardFile(int descriptor, StandardFile what) {
    if (what == StandardFile::Closed) close(descriptor);
    if (what == StandardFile::Full) dup2(open("/dev/full", O_WRONLY), descriptor);
}

[[noreturn]] void execute(const Command &command) {
    std::vector<char *> arguments = {const_cast<char *>(command.program.c_str())};
    for (const std::string &argument : command.arguments)
        arguments.push_back(const_cast<char *>(argument.c_str()));
    arguments.push_back(nullptr);
    execv(command.program.c_str(), arguments.data());
    _exit(126);
}

// A word of the command line, or its begin, which is what a message would have of it.
bool namesAWordOf(const std::string &errors, const Command &command) {
    constexpr std::size_t kShown = 20;
    for (const std::string &word : command.arguments) {
        if (word.find_first_not_of(":,= ") == std::string::npos) return true;  // it is hardly seen
        for (std::size_t begin = 0; begin < word.size();) {
            const std::size_t end = std::min(word.size(), word.find_first_of(":,=", begin));
            const std::string part =
                fuzz_driver::shown(word.substr(begin, end - begin), 100000).substr(0, kShown);
            if (!part.empty() && errors.find(part) != std::string::npos) return true;
            begin = end + 1;
        }
    }
    return errors.find("is required") != std::string::npos;
}

std::string wrongEnd(const Command &command, const Ending &ending) {
    if (const std::string report = fuzz_driver::sanitizerReportIn(ending.errors); !report.empty())
        return "a sanitizer: " + report;
    if (!ending.exited())
        return "an end by " + ending.text() + ": " + fuzz_driver::shown(ending.errors, 1000);
    if (ending.leftProcesses) return "a process that it left:";
    if (ending.exitCode() > 2)
        return "an exit code that is not documented: " + ending.text() + " " +
               fuzz_driver::shown(ending.errors, 1000);
    if (ending.exitCode() == 0 || command.errors != StandardFile::Kept) return {};
    if (ending.errors.empty() && ending.output.empty()) return "an error without a word: " + ending.text();
    if (ending.exitCode() == 2 && !namesAWordOf(ending.errors, command))
        return "a message that names no option: " + fuzz_driver::shown(ending.errors, 1000);
    return {};
}

std::string wrongWords(const std::string &text, const std::string &where) {
    const std::string wrong = fuzz_driver::whatIsNoPlainText(text), name = fuzz_driver::innerNameIn(text);
    if (!wrong.empty()) return where + " that " + wrong + ": " + fuzz_driver::shown(text, 600);
    return name.empty() ? ""
                        : where + " that names the inside, " + name + ": " + fuzz_driver::shown(text, 600);
}

std::string wrongFiles(const Command &command, const Ending &ending, const fs::path &folder,
                       const std::vector<std::string> &before) {
    for (const std::string &file : filesIn(folder)) {
        if (std::count(before.begin(), before.end(), file) > 0) continue;
        const bool isAskedFor =
            std::any_of(command.results.begin(), command.results.end(), [&](const std::string &result) {
                std::error_code none;  // what is no link leads nowhere else
                const fs::path target = fs::read_symlink(folder / result, none);
                return fs::path(result).lexically_normal() == fs::path(file).lexically_normal() ||
                       target == file;
            });
        if (!isAskedFor || ending.exitCode() == 2)
            return "a file that it left: " + fuzz_driver::shown(file) + " with " + ending.text();
    }
    return {};
}

}  // namespace

std::string Command::text() const {
    std::string text;
    for (const auto &[name, value] : environment) text += name + "=" + quoted(value) + " ";
    text += fs::path(program).filename().string();
    for (const std::string &argument : arguments) text += " " + quoted(argument);
    if (closesInput) text += " <&-";
    const auto redirection = [](StandardFile what, const std::string &number) {
        return what == StandardFile::Closed ? " " + number + ">&-"
               : what == StandardFile::Full ? " " + number + ">/dev/full"
                                            : "";
    };
    text += redirection(output, "1") + redirection(errors, "2");
    return input.empty() ? text : text + " <<< '" + fuzz_driver::shown(input) + "'";
}

Ending run(const Command &command, const fs::path &folder) {
    support::Limits limits;
    limits.cpuSeconds = 60;
    limits.seconds = 300;  // machines may be busy
    limits.memory = kMemory;
    const auto start = [&]() -> int {
        if (chdir(folder.c_str()) != 0) return 125;
        for (const auto &[name, value] : command.environment) setenv(name.c_str(), value.c_str(), 1);
        if (command.closesInput) close(STDIN_FILENO);
        setStandardFile(STDOUT_FILENO, command.output);
        setStandardFile(STDERR_FILENO, command.errors);
        execute(command);
    };
    return support::runFunction(start, limits, command.input);
}

std::vector<std::string> filesIn(const fs::path &folder) {
    std::vector<std::string> files;
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) files.push_back(fs::relative(entry.path(), folder).string());
    return files;
}

std::string whatIsWrong(const Command &command, const Ending &ending, const fs::path &folder,
                        const std::vector<std::string> &before) {
    std::string wrong = wrongEnd(command, ending);
    if (wrong.empty()) wrong = wrongWords(ending.errors, "words on standard error");
    if (wrong.empty() && ending.exitCode() != 0)
        wrong = wrongWords(ending.output, "words on standard output");
    if (wrong.empty()) wrong = wrongFiles(command, ending, folder, before);
    return wrong;
}

}  // namespace fuzz_options
