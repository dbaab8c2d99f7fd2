#include "check/unseen.h"

#include <elf.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "text_file.h"

namespace check {

namespace {

// A library's name in its path.
std::string fileName(const std::string &path) { return std::filesystem::path(path).filename(); }

// The file that a shell would start; empty: none.
std::string inPath(const std::string &program) {
    if (program.find('/') != std::string::npos) return program;
    const char *const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/bin:/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const std::string file = folder + '/' + program; access(file.c_str(), X_OK) == 0) return file;
    return "";
}

// Programs for this machine that name no loader (PT_INTERP).
bool isStaticallyLinked(const std::string &file) {
    std::ifstream stream(file, std::ios::binary);
    Elf64_Ehdr header{};
    if (!stream.read(reinterpret_cast<char *>(&header), sizeof header) ||
        std::string(header.e_ident, header.e_ident + SELFMAG) != ELFMAG || header.e_ident[EI_CLASS] != ELFCLASS64)
        return false;
    stream.seekg(static_cast<std::streamoff>(header.e_phoff));
    for (int i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment{};
        if (!stream.read(reinterpret_cast<char *>(&segment), sizeof segment) || segment.p_type == PT_INTERP) return false;
    }
    return true;
}

bool hasOtherRights(const std::string &file) {
    struct stat status {};
    return stat(file.c_str(), &status) == 0 && (status.st_mode & (S_ISUID | S_ISGID)) != 0;
}

// The list of its features, in which names follow one another, is in every build of ODE. Programs that ask for one have its name
// alone.
bool containsOde(const std::string &file) {
    const std::string text = bench::readWhatIsThere(file);
    return text.find(" ODE_double_precision") != std::string::npos || text.find(" ODE_single_precision") != std::string::npos;
}

std::string whyNotLoaded(const Play &play, const std::string &program, const std::string &file) {
    if (isStaticallyLinked(file))
        return "'" + program + "' is statically linked: no library of it can be exchanged, and nothing of it observed.";
    if (hasOtherRights(file))
        return "'" + program +
               "' runs with another user's rights (set-user-ID): the loader ignores LD_LIBRARY_PATH and LD_PRELOAD.";
    const std::string words = play.run.errors.lastLines(3);
    return "The observer was not loaded into '" + program + "'" + (words.empty() ? "." : ": " + words);
}

std::string whyNoWorld(const Play &play, const std::string &program, const std::string &file) {
    std::vector<std::string> objects = play.record.objects;
    objects.push_back(file);
    std::string library;
    for (const std::string &object : objects) {
        if (fileName(object) == "libode.so.8" || fileName(object).rfind("libode.so.8.", 0) == 0)
            library = object;
        else if (containsOde(object))
            return "'" + object +
                   "' has a copy of ODE inside. No libode.so.8 is used in its place, on neither side (docs/programs.md).";
    }
    if (!library.empty())
        return "'" + program + "' loads libode.so.8, but no call of dWorldCreate, dWorldStep or dWorldQuickStep was seen.";
    return "No process of '" + program + "' uses libode.so.8, or none did before its end.";
}

std::string whyNoStepOfWorlds(const Play &play, const std::string &program) {
    for (const ProcessRecord &process : play.record.processes)
        if (!process.isDouble)
            return "'" + process.library +
                   "' has single precision. Debian's libode8 has double precision, and only that is compared.";
    for (const ProcessRecord &process : play.record.processes)
        if (process.isFull) return "No step could be recorded: there is no room in '" + play.folder + "'.";
    return "'" + program + "' makes worlds of ODE, but steps none: no call of dWorldStep or dWorldQuickStep was seen.";
}

}  // namespace

std::optional<std::string> whyNoSteps(const Play &play, const std::string &program) {
    if (play.record.steps() > 0) return std::nullopt;
    const std::string file = inPath(program);
    std::string reason = !play.record.wasLoaded          ? whyNotLoaded(play, program, file)
                         : play.record.processes.empty() ? whyNoWorld(play, program, file)
                                                         : whyNoStepOfWorlds(play, program);
    if (play.wasEnded()) return reason + " The run was ended from outside.";
    if (play.run.status == 0) return reason;
    const std::string words = play.run.errors.lastLines(3);
    return reason + " It ended with " + play.ending() + (words.empty() ? "." : ": " + words);
}

std::optional<std::string> whyWrongLibrary(const Play &play) {
    for (const ProcessRecord &process : play.record.processes) {
        if (fileName(process.library).rfind("libode.so.8", 0) != 0)
            return "'" + process.program + "' uses '" + process.library +
                   "': a copy of ODE under another name, which is not exchanged (docs/programs.md).";
        if (process.isOurs != play.engine.isOurs())
            return "'" + process.program + "' was to run on " + (play.engine.isOurs() ? "ODE_MT" : "libode8") + ", and uses '" +
                   process.library +
                   "' all the same: it looks for libraries in a folder of its own (RPATH), or loads this one by its path.";
        if (process.isFull) return "Not all steps could be recorded: there is no room in '" + play.folder + "'.";
    }
    return std::nullopt;
}

}  // namespace check
