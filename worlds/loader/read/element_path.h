// Names places in an SDF file.
#pragma once

#include "loader/description/parameters.h"

#include <sdf/Element.hh>

#include <string>

namespace worlds {

// The place of an element: in the file of the nearest include around it, or in `worldFile`.
Place placeOf(const sdf::ElementPtr &element, const std::string &worldFile);

// "model[m]" for an element of type "model" named "m"; null: no name.
std::string shownName(const std::string &type, const char *name);

// libsdformat's own way to write a path, /sdf/world[@name="w"]/model[@name="m"], in ours.
std::string shortPath(const std::string &xmlPath);

// An element and what was written inside it; defaults that libsdformat added are excluded.
Parameters toParameters(const sdf::ElementPtr &element, const std::string &worldFile);

// Calls `visit(child)` for every child that was written in the file.
template <class Visit>
void forEachWritten(const sdf::ElementPtr &element, Visit visit) {
    for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement())
        if (child->GetExplicitlySetInFile()) visit(child);
}

}  // namespace worlds
