// The same world in other letters: line breaks, comments, the order of attributes, other spellings of a
// number or flag.
#pragma once

#include "driver/random.h"
#include "worlds/world_case.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fuzz_worlds {

enum class Spelling {
    Indentation,
    Comments,        // between elements
    CommentsInText,  // before, behind and between the words of a value
    Attributes,      // in reverse order, in other quotes
    Numbers,
    Flags,
    Blanks,       // around and between the words of a value
    Cdata,        // a value as <![CDATA[...]]>
    References,   // characters of a value as &#49;
    LineEnds,     // as \r\n
    Declaration,  // without <?xml ...?>
    Mark,         // a byte order mark
    Order         // of elements that are there once
};
constexpr int kSpellings = static_cast<int>(Spelling::Order) + 1;
const char *nameOf(Spelling spelling);

// Every SDF file of the case spelled in these ways; the same seed gives the same spelling. What is no XML
// stays.
WorldCase respelled(const WorldCase &world, const std::vector<Spelling> &ways, std::uint64_t seed);

}  // namespace fuzz_worlds
