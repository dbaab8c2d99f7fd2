// Where the two libode.so.8 are that are compared.
#pragma once

#include <string>
#include <vector>

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

// Returns the files that LD_PRELOAD names, as it names them: programs that are started load them first.
std::vector<std::string> preloadedLibraries();

}  // namespace bench
