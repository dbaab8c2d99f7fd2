#include "call_recipes.h"

namespace kept_state {

const CallRecipes &callRecipes() {
    static const CallRecipes recipes = [] {
        CallRecipes all;
        addCollisionCalls(all);
        addShapeCalls(all);
        addSpaceCalls(all);
        addMeshCalls(all);
        addHeightCalls(all);
        addWorldCalls(all);
        addBodyCalls(all);
        addJointCalls(all);
        addNewCalls(all);
        addNumberCalls(all);
        addOtherCalls(all);
        return all;
    }();
    return recipes;
}

}  // namespace kept_state
