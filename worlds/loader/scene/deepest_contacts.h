// Picks the contacts of a pair that become joints.
#pragma once

#include <ode/ode.h>

#include <vector>

namespace worlds {

// Numbers of the `limit` deepest of the first `count` contacts, in their own order. Of equally deep
// ones the earlier is taken.
std::vector<int> deepestContacts(const std::vector<dContact> &contacts, int count, int limit);

}  // namespace worlds
