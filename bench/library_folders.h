// Where the two libode.so.8 are that are compared, and the environment in which programs get one of them.
#pragma once

#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace bench {

std::string folderOfThisProgram();

std::string folderOfStockLibrary();
// How a user gets Debian's library beside ours, as commands: the package libode8-mt takes its place.
std::string commandsForStockLibrary();
// Of this program's neighbours, in an installed tree as in a build folder; else the one it was built with.
std::string folderOfOurLibrary();

// Throws std::invalid_argument, naming the option, if there is no libode.so.8 in its folder.
void checkLibraryFolder(const std::string &option, const std::string &folder);

// Returns the file that a path names: itself, or the libode.so.8 in it if it is a folder. There may be none.
std::string libraryAt(const std::string &path);

// Makes a folder in `in` where a library alone is, so that programs find no others in it than without. Returns its path.
std::string addLibrary(const support::TemporaryFolder &in, const std::string &folder, const std::string &library);

// A variable of the environment that is a list of paths, with one more in front.
std::string inFront(const std::string &path, const char *variable);

// Returns the names of all ODE_MT_... variables that are set, but for ODE_MT_WORLDS, which is the loader's.
// Variables are recognised by their prefix, so that those of later versions are included.
std::vector<std::string> libraryVariables();

// Returns the files that LD_PRELOAD names, as it names them: programs that are started load them first.
std::vector<std::string> preloadedLibraries();

}  // namespace bench
