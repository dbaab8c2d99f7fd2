// Lists with commas between their words. A comma that belongs to a word, as in the name of a file, is written "\,".
#pragma once

#include <string>
#include <vector>

namespace bench {

// The words as they are written.
std::vector<std::string> splitAtCommas(const std::string &list);

// The words for a reader: "a, b, c".
std::string joinWords(const std::vector<std::string> &words);

// A word as it is meant: "\," is a comma.
std::string withoutEscapes(const std::string &word);

}  // namespace bench
