// An SDF document: read, checked element by element, and resolved by libsdformat.
#pragma once

#include "loader/read/issues.h"
#include "loader/read/resource_finder.h"

#include <sdf/Root.hh>

#include <string>

namespace worlds {

class Document {
public:
    // `file` names the text in messages. Throws LoadError.
    Document(const std::string &text, const std::string &file, const ResourceFinder &resources,
             const Issues &issues);

    const sdf::World &world() const { return *m_root.WorldByIndex(0); }

private:
    sdf::Root m_root;
};

}  // namespace worlds
