#include "loader/read/obj_check.h"

#include "loader/load_error.h"
#include "loader/read/mesh_fault.h"
#include "loader/read/word_list.h"

#include <algorithm>

namespace worlds {

namespace {

class ObjCheck {
public:
    void line(std::string_view text, std::size_t number) {
        m_line = number;
        WordList words(text);
        const std::string_view kind = words.next();
        if (kind == "v") vertex(words);
        if (kind == "f") face(words);
    }

    void end() const {
        if (m_largest > m_vertices)
            throw MeshFault("a face has a vertex " + std::to_string(m_largest) + " of " +
                            std::to_string(m_vertices));
    }

private:
    // The coordinates may be followed by a weight or a colour.
    void vertex(WordList words) {
        int count = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++count)
            if (!finiteNumber(word)) fail(quote(std::string(word)) + " is not a finite number");
        if (count < 3) fail("a vertex has " + std::to_string(count) + " coordinates");
        ++m_vertices;
    }

    // A corner is "vertex", "vertex/texture" or "vertex/texture/normal"; from -1 downwards vertices are
    // counted backwards from the last one before the face.
    void face(WordList words) {
        std::size_t corners = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            if (word[0] == '#') break;
            const std::optional<std::int64_t> vertex = wholeNumber(word.substr(0, word.find('/')));
            if (!vertex || *vertex == 0 || -*vertex > m_vertices)
                fail("a face has no vertex " + quote(std::string(word)));
            m_largest = std::max(m_largest, *vertex);
            if (++corners > maxCorners)
                fail("a face has more than " + std::to_string(maxCorners) + " corners");
        }
        if (corners == 0) fail("a face has no corners");
    }

    [[noreturn]] void fail(const std::string &what) const {
        throw MeshFault("line " + std::to_string(m_line) + ": " + what);
    }

    std::int64_t m_vertices = 0, m_largest = 0;
    std::size_t m_line = 0;
};

}  // namespace

void checkObj(const std::string &text) {
    ObjCheck check;
    std::string joined;  // of lines that end in a backslash
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = std::string_view(text).substr(at, end - at);
        at = end + 1;
        ++number;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (!line.empty() && line.back() == '\\') {
            joined.append(line.substr(0, line.size() - 1)) += ' ';
        } else if (joined.empty()) {
            check.line(line, number);
        } else {
            check.line(joined.append(line), number);
            joined.clear();
        }
    }
    if (!joined.empty()) check.line(joined, number);
    check.end();
}

}  // namespace worlds
