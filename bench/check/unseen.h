// Why a run cannot be compared: nothing was seen of it, or not what it was to run on.
#pragma once

#include <optional>
#include <string>

#include "check/play.h"

namespace check {

// In a sentence or two. Empty: it can be compared.
std::optional<std::string> whyNoSteps(const Play &play, const std::string &program);
std::optional<std::string> whyWrongLibrary(const Play &play);

}  // namespace check
