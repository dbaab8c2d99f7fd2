// Functions that scripts call: none, as ODE 0.16.2 is the oldest release.
#include "function.h"

namespace fuzz {

void addNewFunctions(std::vector<Function> &) {}

}  // namespace fuzz
