// The verdict for people, and for programs.
#pragma once

#include <string>

#include "check/checker.h"

namespace check {

std::string reportText(const CheckResult &result);
std::string reportJson(const CheckResult &result);

}  // namespace check
