#include "loader/load_error.h"

namespace worlds {

std::string toString(const Place &place) {
    return place.path.empty() ? place.file : place.file + ": " + place.path;
}

}  // namespace worlds
