// A pattern on the part of the stack that the next call uses: of an automatic variable that upstream reads before it has
// written it, the value is then another one than that which an earlier call left there.
#pragma once

namespace fuzz {

void fillStackBelow();

}  // namespace fuzz
