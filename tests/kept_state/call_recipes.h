// How the call test calls each exported function: with valid arguments, on objects of the scene.
#pragma once

#include "call_scene.h"

#include <string>
#include <vector>

namespace kept_state {

struct CallRecipe {
    using Call = std::function<void(CallScene &)>;

    std::string function;
    Call call;
    Call undo = nullptr;      // the opposite call; none: the call may be made twice and not undone
    bool readsOnly = false;   // changes nothing: fewer contexts are enough
    bool inLocked = true;     // false: upstream changes a locked space half way, and cannot continue
    bool inStep = true;       // false: upstream frees what a step in progress uses
    bool inUserCode = true;   // false: upstream leaves half an object behind
    bool inCollision = true;  // false: upstream's cleaning or collider continues with data that the call overwrites
    bool amidStep = true;     // false: upstream's step continues with data that the call overwrites
    bool anySpace = false;    // says nothing to geoms or spaces: one kind of space at a time is enough
    bool everySpace = false;  // is for spaces: all kinds of them, not alternately
};

using CallRecipes = std::vector<CallRecipe>;
const CallRecipes &callRecipes();

// One function for each of upstream's headers, defined in calls_*.cpp.
void addCollisionCalls(CallRecipes &recipes);
void addShapeCalls(CallRecipes &recipes);
void addSpaceCalls(CallRecipes &recipes);
void addMeshCalls(CallRecipes &recipes);
void addHeightCalls(CallRecipes &recipes);
void addWorldCalls(CallRecipes &recipes);
void addBodyCalls(CallRecipes &recipes);
void addJointCalls(CallRecipes &recipes);
void addJointTypeCalls(CallRecipes &recipes);
void addNewCalls(CallRecipes &recipes);  // of newer releases of ODE, where the release has them
void addNumberCalls(CallRecipes &recipes);
void addOtherCalls(CallRecipes &recipes);

}  // namespace kept_state
