// Whether Debian's library, playing a script, has a branch that depends on unwritten memory: valgrind's memcheck sees
// what does not hang on what a pattern on the stack changes.
#pragma once

#include <string>

namespace fuzz {

// `text` as `odemt_fuzz_player FILE` takes it. False where valgrind is not installed.
bool readsUnsetMemory(const std::string &player, const std::string &libraryFolder, const std::string &text);

}  // namespace fuzz
