#include "loader/scene/deepest_contacts.h"

#include <algorithm>
#include <numeric>

namespace worlds {

std::vector<int> deepestContacts(const std::vector<dContact> &contacts, int count, int limit) {
    std::vector<int> chosen(static_cast<std::size_t>(count));
    std::iota(chosen.begin(), chosen.end(), 0);
    if (count <= limit) return chosen;
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](int a, int b) { return contacts[a].geom.depth > contacts[b].geom.depth; });
    chosen.resize(static_cast<std::size_t>(limit));
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

}  // namespace worlds
