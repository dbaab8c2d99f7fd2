#include "loader/load_error.h"

#include "support/text.h"

namespace worlds {

std::string toString(const Place &place) {
    const std::string text = place.path.empty() ? place.file : place.file + ": " + support::shortened(place.path);
    return support::printable(text);
}

LoadError::LoadError(Kind kind, const Place &place, const std::string &what)
    : std::runtime_error(toString(place) + ": " + support::printable(what)), m_kind(kind), m_place(place), m_reason(what) {}

}  // namespace worlds
