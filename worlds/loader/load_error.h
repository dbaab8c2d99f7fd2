// What loading a world can fail with, and where in which file.
#pragma once

#include <stdexcept>
#include <string>

namespace worlds {

// A place in an SDF file. The path names elements as "/sdf/world/model[robot]/joint[j1]/axis"; it is
// empty when the whole file is meant.
struct Place {
    std::string file;
    std::string path;
};
std::string toString(const Place &place);

class LoadError : public std::runtime_error {
public:
    enum class Kind {
        File,         // cannot be read
        Syntax,       // not well-formed XML, or not SDF
        Value,        // an element holds what it may not hold
        Unsupported,  // valid SDF that this loader does not simulate
        Resource      // a mesh, image or model named by the file is missing or broken
    };

    LoadError(Kind kind, const Place &place, const std::string &what)
        : std::runtime_error(toString(place) + ": " + what), m_kind(kind), m_place(place) {}

    Kind kind() const { return m_kind; }
    const Place &place() const { return m_place; }

private:
    Kind m_kind;
    Place m_place;
};

}  // namespace worlds
