// Where the timeline of one engine in one world is written (--trace).
#pragma once

#include <cstddef>
#include <string>

namespace bench {

// The file itself if there is one run; otherwise world and engine stand before its ending: trace-create-ours-2.json. Of them, what is no letter or
// digit becomes a hyphen.
std::string traceFileOf(const std::string &file, const std::string &world, const std::string &engine, std::size_t runs);

}  // namespace bench
