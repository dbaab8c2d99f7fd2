#include "two_libraries.h"

#include "support/child_run.h"
#include "support/text.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace exactness {

namespace {

std::string folderOf(Library library) {
    const bool isOurs = library == Library::Ours;
    const char *given = std::getenv(isOurs ? "ODE_MT_LIBRARY_DIR" : "ODE_MT_STOCK_LIBRARY_DIR");
    if (given != nullptr) return given;
    return isOurs ? ODE_MT_LIBRARY_DIR : ODE_MT_STOCK_LIBRARY_DIR;
}

}  // namespace

Lines linesOn(Library library, const Lines &command, const char *memoryPattern) {
    const std::string folder = folderOf(library);
    const support::Ending child =
        support::runProgram(command, {{"LD_LIBRARY_PATH", folder}, {"MALLOC_PERTURB_", memoryPattern}});
    if (!child.exitedWith(0))
        throw std::runtime_error(command[0] + " on " + folder + ": " + child.text() + "\n" + child.errors);
    return support::split(child.output, '\n');
}

std::string firstDifference(const Lines &onDebian, const Lines &onOurs) {
    const auto lineOf = [](const Lines &lines, std::size_t number) {
        return number < lines.size() ? lines[number] : std::string("nothing");
    };
    for (std::size_t i = 1; i < std::max(onDebian.size(), onOurs.size()); ++i)
        if (lineOf(onDebian, i) != lineOf(onOurs, i))
            return "  libode8: " + lineOf(onDebian, i) + "\n  ODE_MT:  " + lineOf(onOurs, i);
    return "";
}

}  // namespace exactness
