#include "loader/read/stl_check.h"

#include "loader/load_error.h"
#include "loader/read/mesh_fault.h"
#include "loader/read/word_list.h"

#include <algorithm>
#include <cstring>

namespace worlds {

namespace {

constexpr std::size_t headerBytes = 80, triangleBytes = 50;

bool isBinary(const std::string &bytes) {
    std::uint32_t triangles = 0;
    if (bytes.size() < headerBytes + sizeof triangles) return false;
    std::memcpy(&triangles, bytes.data() + headerBytes, sizeof triangles);  // little-endian, as this machine
    return bytes.size() - headerBytes - sizeof triangles ==
           triangleBytes * static_cast<std::uint64_t>(triangles);
}

class TextCheck {
public:
    explicit TextCheck(std::string_view text) : m_text(text) {}

    void solids() {
        while (skipBlank()) {
            expect("solid");
            skipLine();  // the name
            while (peek() == "facet") facet();
            expect("endsolid");
            skipLine();
        }
    }

private:
    void facet() {
        expect("facet");
        expect("normal");
        numbers();
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            numbers();
        }
        expect("endloop");
        expect("endfacet");
    }

    void numbers() {
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = next();
            if (!finiteNumber(word)) fail(word, "a finite number");
        }
    }
    void expect(std::string_view wanted) {
        if (const std::string_view word = next(); word != wanted) fail(word, "'" + std::string(wanted) + "'");
    }

    bool skipBlank() {
        const std::size_t begin = m_text.find_first_not_of(" \t\r\n");
        m_text.remove_prefix(std::min(begin, m_text.size()));
        return !m_text.empty();
    }
    void skipLine() { m_text.remove_prefix(std::min(m_text.find('\n'), m_text.size())); }
    std::string_view peek() const { return WordList(m_text).next(); }
    std::string_view next() {
        const std::string_view word = peek();
        if (!word.empty())
            m_text.remove_prefix(static_cast<std::size_t>(word.data() + word.size() - m_text.data()));
        return word;
    }

    [[noreturn]] static void fail(std::string_view word, const std::string &wanted) {
        throw MeshFault((word.empty() ? "ends" : "has " + quote(std::string(word))) + " where " + wanted +
                        " has to be; it is no binary STL either");
    }

    std::string_view m_text;
};

}  // namespace

void checkStl(const std::string &bytes) {
    if (!isBinary(bytes)) TextCheck(bytes).solids();
}

}  // namespace worlds
