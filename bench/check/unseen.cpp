#include "check/unseen.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "library_folders.h"
#include "support/text_file.h"
#include "support/text.h"

namespace check {

namespace {

// A library's name in its path.
std::string fileName(const std::string &path) { return std::filesystem::path(path).filename(); }

// The file that a shell would start; empty: none.
std::string inPath(const std::string &program) {
    if (program.find('/') != std::string::npos) return program;
    const char *const path = std::getenv("PATH");
    for (const std::string &folder : support::split(path != nullptr ? path : "/bin:/usr/bin", ':'))
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
    const std::string text = support::readWhatIsThere(file);
    return text.find(" ODE_double_precision") != std::string::npos || text.find(" ODE_single_precision") != std::string::npos;
}

// For the header of a record: also where the program has filled the folder, and left it so.
bool hasRoom(const std::string &folder) {
    std::string path = folder + "/room_XXXXXX";
    const int file = mkstemp(path.data());
    const bool has = file >= 0 && posix_fallocate(file, 0, static_cast<off_t>(kHeaderBytes)) == 0;
    if (file >= 0) {
        close(file);
        unlink(path.c_str());
    }
    return has;
}

std::string noRoom(const Play &play, const std::string &program) {
    return "Nothing of '" + program + "' can be told: there is no room for records in '" + play.folder + "' (TMPDIR names another folder).";
}

std::string whyNotLoaded(const Play &play, const std::string &program, const std::string &file) {
    if (isStaticallyLinked(file))
        return "'" + program + "' is statically linked: no library of it can be exchanged, and nothing of it observed.";
    if (hasOtherRights(file))
        return "'" + program +
               "' runs with another user's rights (set-user-ID): the loader ignores LD_LIBRARY_PATH and LD_PRELOAD.";
    const std::string words = play.run.errors.lastLines(3);
    if (!hasRoom(play.folder)) return noRoom(play, program);
    return "The observer was not loaded into '" + program + "'" + (words.empty() ? "." : ": " + words);
}

std::string whyNoWorld(const Play &play, const std::string &program, const std::string &file) {
    if (play.record.headless > 0 || !hasRoom(play.folder)) return noRoom(play, program);
    std::vector<std::string> objects = play.record.objects;
    objects.push_back(file);
    std::string library;
    for (const std::string &object : objects) {
        if (fileName(object) == "libode.so.8" || fileName(object).rfind("libode.so.8.", 0) == 0)
            library = object;
        else if (containsOde(object))
            return "'" + object +
                   "' has a copy of ODE inside. No libode.so.8 is used in its place, on neither side (docs/start.md).";
    }
    if (!library.empty())
        return "'" + program + "' loads libode.so.8, but no call of dWorldCreate, dWorldStep or dWorldQuickStep was seen.";
    return "No process of '" + program +
           "' was seen to use libode.so.8. Not seen are those that are started with an emptied environment (env -i), statically linked, or "
           "with another user's rights, and what one had loaded that was killed.";
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

// How a process comes to another library than the one that LD_LIBRARY_PATH names.
std::string wayTo(const std::string &library) {
    std::error_code ignored;
    for (const std::string &preloaded : bench::preloadedLibraries())
        if (std::filesystem::equivalent(preloaded, library, ignored)) return "LD_PRELOAD names it.";
    return "it looks for libraries in a folder of its own (RPATH), or loads this one by its path.";
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
                   "': ODE under another name, which is not exchanged (docs/start.md).";
        if (process.isOurs != play.engine.isOurs())
            return "'" + process.program + "' was to run on " + (play.engine.isOurs() ? "ODE_MT" : "libode8") + ", and uses '" +
                   process.library + "' all the same: " + wayTo(process.library);
        if (process.isFull) return "Not all steps could be recorded: there is no room in '" + play.folder + "'.";
    }
    return std::nullopt;
}

}  // namespace check
