// Recipes for new functions: none, as ODE 0.16.2 is the oldest release.
#include "call_recipes.h"

namespace kept_state {

void addNewCalls(CallRecipes &) {}

}  // namespace kept_state
