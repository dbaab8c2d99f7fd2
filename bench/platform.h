// What measurements run on: the machine, and which libode.so.8, as a file and in this process.
#pragma once

#include <ode/common.h>

#include <iosfwd>
#include <string>

#include "serial_share.h"

namespace bench {

// The machine that the bench runs on, for readers of its figures.
struct Machine {
    std::string processor;  // as /proc/cpuinfo names it; empty: it does not
    unsigned cores;         // that this process may use
};

Machine thisMachine();

// The first "model name" in what /proc/cpuinfo holds; empty if there is none.
std::string readProcessor(std::istream &cpuinfo);

// Which release of ODE is in a file of libode.so.8. The file is read, never loaded; of the library that this process runs on,
// LibraryProbe::release() tells it.
//
// ODE itself has no call for it: dODE_VERSION is that of the header that a program was compiled with. Ours says it; any other library
// is known by the number in the name of its file, which each release has raised (libode.so.8.0.2, libode.so.8.2.0).
inline const std::string kUnknownRelease = "unknown";

// Returns "0.16.2", "0.16.6", or kUnknownRelease. Symbolic links are followed.
std::string releaseOfLibrary(const std::string &file);

// The same, by the name of the file alone.
std::string releaseByName(const std::string &file);

// Returns whether a file is ODE_MT's libode: it has the name of dToggleODE_MT in it, which programs that call it do not define.
bool isOurLibrary(const std::string &file);

// Returns false also where one of the two is unknown.
bool areOtherReleases(const std::string &one, const std::string &other);

// Which libode.so.8 this process really runs on, and what it says of itself. ODE_MT's own functions
// are looked up by name: the program is linked to what Debian's library exports.
struct LibraryProbe {
    std::string file;  // of the library that defines dWorldStep
    bool isOurs;       // it exports dToggleODE_MT

    // Returns the release of ODE in it, "0.16.2"; kUnknownRelease where neither it nor its file's name says so.
    std::string release() const;

    // The settings of our library; 0 and empty with Debian's.
    int threads() const;
    std::string manager() const;
    std::string algorithm() const;
    std::string callbacks() const;   // the callback policy
    int gridCells() const;           // 0: tuned
    unsigned sharedSteps() const;    // number of parallel steps, by islands or of a large island, since the process started

    // Of a world's last frame; of none before the first call, from which on the library records frames. Nothing with Debian's.
    SerialWork workOf(dWorldID world) const;
};

LibraryProbe probeLibrary();

}  // namespace bench
