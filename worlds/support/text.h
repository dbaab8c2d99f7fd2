// Text: words of lists, quotation, and text that anyone may have written, made fit to be shown.
#pragma once

#include <string>
#include <vector>

namespace support {

// The parts between separators: "a,,b" has three, of which one is empty; an empty text has none, and a separator at the end begins none.
std::vector<std::string> split(const std::string &text, char separator);

// The words between blanks, tabs and line breaks.
std::vector<std::string> splitAtBlanks(const std::string &text);

// Lists with commas between their words. A comma that belongs to a word, as in the name of a file, is written "\,". The words are returned as
// they are written.
std::vector<std::string> splitAtCommas(const std::string &list);

// A word of such a list as it is meant: "\," is a comma.
std::string withoutEscapes(const std::string &word);

// "a, b, c"
std::string join(const std::vector<std::string> &words, const std::string &separator = ", ");

// In double quotes, with quotes in it doubled, as SQL and CSV files have names.
std::string doubleQuoted(const std::string &text);

// A field of a CSV file (RFC 4180): double-quoted if it holds a comma, a quote or a line break.
std::string csvField(const std::string &text);

// With control characters, bytes that are no UTF-8 and changes of the direction of writing as \x1b.
std::string printable(const std::string &text);

// Long text by its begin and end.
std::string shortened(const std::string &text);

// Text in quotes; long text is shown by its begin and end.
std::string quote(const std::string &text);

}  // namespace support
