// A byte on the part of the stack that the next call uses: of an automatic variable that upstream reads before it has
// written it, the value is then another one than that which an earlier call left there.
#pragma once

#include <cstdint>

namespace fuzz {

void fillStackBelow(std::uint8_t byte);

}  // namespace fuzz
