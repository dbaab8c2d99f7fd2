// Two runs of the bench, from their JSON files: what has become faster or slower.
//
// Times of two runs cannot be told from a change of the machine's mood; speed-ups over the first engine of the same run can.
#pragma once

#include <string>

namespace bench {

// Returns a table of the worlds and engines of both, in which those that one alone has, or that failed, are marked. Throws
// std::runtime_error, with the file's name, if one is no result of the bench, or if there is nothing that both measured.
std::string compareResults(const std::string &before, const std::string &after);

}  // namespace bench
