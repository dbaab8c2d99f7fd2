// Which libode.so.8 this process really runs on, and what it says of itself. ODE_MT's own functions
// are looked up by name: the program is linked to what Debian's library exports.
#pragma once

#include <string>

namespace bench {

struct LibraryProbe {
    std::string file;  // of the library that defines dWorldStep
    bool isOurs;       // it exports dToggleODE_MT

    // Returns the release of ODE in it, "0.16.2"; kUnknownRelease (library_release.h) where neither it nor its file's name says so.
    std::string release() const;

    // The settings of our library; 0 and empty with Debian's.
    int threads() const;
    std::string manager() const;
    std::string algorithm() const;
    std::string callbacks() const;   // the callback policy
    int gridCells() const;           // 0: tuned
    unsigned sharedSteps() const;    // number of parallel steps, by islands or of a large island, since the process started
};

LibraryProbe probeLibrary();

}  // namespace bench
