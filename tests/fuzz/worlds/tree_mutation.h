// Changes of an XML tree that know nothing of whether the result is a world.
#pragma once

#include "driver/random.h"
#include "worlds/xml_tree.h"

namespace fuzz_worlds {

// One change. `files` are names that a reference may be set to.
void mutateTree(XMLDocument &xml, fuzz_driver::Random &random, const std::vector<std::string> &files);

}  // namespace fuzz_worlds
