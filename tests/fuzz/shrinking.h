// Makes a script small while it stays interesting: calls go, then numbers get simple.
#pragma once

#include "call.h"

#include <functional>

namespace fuzz {

// `isInteresting` of the script is true.
Script shrink(Script script, const std::function<bool(const Script &)> &isInteresting);

}  // namespace fuzz
