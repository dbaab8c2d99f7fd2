// Which release of ODE is in a file of libode.so.8. The file is read, never loaded; of the library that this process runs on,
// LibraryProbe::release() tells it.
//
// ODE itself has no call for it: dODE_VERSION is that of the header that a program was compiled with. Ours says it; any other library
// is known by the number in the name of its file, which each release has raised (libode.so.8.0.2, libode.so.8.2.0).
#pragma once

#include <string>

namespace bench {

inline const std::string kUnknownRelease = "unknown";

// Returns "0.16.2", "0.16.6", or kUnknownRelease. Symbolic links are followed.
std::string releaseOfLibrary(const std::string &file);

// The same, by the name of the file alone.
std::string releaseByName(const std::string &file);

// Returns whether a file is ODE_MT's libode: it has the name of dToggleODE_MT in it, which programs that call it do not define.
bool isOurLibrary(const std::string &file);

// Returns false also where one of the two is unknown.
bool areOtherReleases(const std::string &one, const std::string &other);

}  // namespace bench
