// A range of sizes as one word behind --worlds: "pile:1000..8000,sap".
#pragma once

#include <string>
#include <vector>

namespace bench {

// One world for each size from the first to at most the last, each twice the one before; a world without
// such a range is itself. So is one whose range makes no sense: as a size it is complained of by name.
std::vector<std::string> expandSizes(const std::string &world);

}  // namespace bench
