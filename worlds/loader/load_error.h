// What loading a world can fail with, and where in which file.
#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "support/text.h"

namespace worlds {

// A place in an SDF file. The path names elements as "/sdf/world/model[robot]/joint[j1]/axis"; it is
// empty when the whole file is meant.
struct Place {
    std::string file;
    std::string path;
};
// For messages: a long path is shown by its begin and end.
inline std::string toString(const Place &place) {
    return support::printable(place.path.empty() ? place.file : place.file + ": " + support::shortened(place.path));
}

class LoadError : public std::runtime_error {
public:
    enum class Kind {
        File,         // cannot be read
        Syntax,       // not well-formed XML, or not SDF
        Value,        // an element holds what it may not hold
        Unsupported,  // valid SDF that this loader does not simulate
        Memory,       // there is too little of it
        Resource      // a mesh, image or model named by the file is missing or broken
    };

    LoadError(Kind kind, const Place &place, const std::string &what)
        : std::runtime_error(toString(place) + ": " + support::printable(what)), m_kind(kind), m_place(place), m_reason(what) {}

    Kind kind() const { return m_kind; }
    const Place &place() const { return m_place; }
    const std::string &reason() const { return m_reason; }  // what() without the place

private:
    Kind m_kind;
    Place m_place;
    std::string m_reason;
};

// Calls `work`; too little memory within it is reported at `place`.
template <class Work>
auto withMemoryFor(const Place &place, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        throw LoadError(LoadError::Kind::Memory, place, "too little memory");
    }
}

}  // namespace worlds
