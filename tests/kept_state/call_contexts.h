// When, in the life of a scene, the call test makes its call: between frames, in every kind of callback, in
// every kind of code that a program gives to ODE.
#pragma once

#include "call_recipes.h"

#include <functional>
#include <string>

namespace kept_state {

enum class When {
    // The first: a getter is asked once in a process.
    colliderGetter,
    between,
    asked,       // after all boxes have been asked for
    beforeStep,  // between collision and step
    near,
    nearOther,  // in a near-callback of another space
    moved,
    twice,
    undone,
    collider,
    boxFunction,
    boxTest,
    destructor,
    spaceDestroyed,  // in the destructor of a geom of a space that is being destroyed
    triangleCallback,
    heightCallback,
    messageHandler,  // in a step
    debugHandler,    // in a near-callback
    allocator,
    stepMemory,
    threadEnd,  // when the data of another thread are destroyed
    last        // before all is destroyed
};
const char *nameOf(When when);

struct Case {
    const CallRecipe &recipe;
    When when;
    SpaceKind kind;
    Place place;
    int turn;

    std::string name() const;
};

// Visits the cases of the function `number`: kinds of spaces, and places within them, alternately.
// ODE_MT_EXACTNESS=thorough: all of them.
void forEachCase(const CallRecipe &recipe, int number, const std::function<void(const Case &)> &visit);

// Before the first frame, and after the second.
void prepare(CallScene &scene, const Case &c);
void makeCall(CallScene &scene, const Case &c);

}  // namespace kept_state
