#include "loader/read/mesh_file.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "loader/read/collada_file.h"
#include "loader/read/regular_file.h"
#include "loader/read/word_list.h"
#include "support/text.h"

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
            if (!finiteNumber(word)) fail(support::quote(std::string(word)) + " is not a finite number");
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
                fail("a face has no vertex " + support::quote(std::string(word)));
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
        throw MeshFault((word.empty() ? "ends" : "has " + support::quote(std::string(word))) + " where " + wanted +
                        " has to be; it is no binary STL either");
    }

    std::string_view m_text;
};

// Throws MeshFault for a vertex that is not three finite numbers or more, a face whose corners are no
// vertices of the file, and one with more than maxCorners.
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

// Throws MeshFault for a file that is neither binary, with room for exactly the triangles that it says it
// holds, nor text, with every facet a triangle of finite numbers and every solid ended.
void checkStl(const std::string &bytes) {
    if (!isBinary(bytes)) TextCheck(bytes).solids();
}

constexpr std::uintmax_t longestMeshFile = 1u << 30;  // bytes

// Makes the file's text safe to import.
using Prepare = std::string (*)(std::string);

template <void (*check)(const std::string &)>
std::string checked(std::string text) {
    check(text);
    return text;
}

// Returns the formats by the suffix of the file's name. Assimp supports more formats, whose contents it does not check.
const std::map<std::string, Prepare> &formats() {
    static const std::map<std::string, Prepare> all = {
        {".dae", [](std::string text) { return reduceCollada(text); }},
        {".obj", checked<checkObj>},
        {".stl", checked<checkStl>},
    };
    return all;
}

std::string extensionOf(const std::string &file) {
    std::string extension = std::filesystem::path(file).extension();
    for (char &letter : extension)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return extension;
}

// A mesh may name further files, of materials for one: none is opened.
class NoFiles : public Assimp::IOSystem {
public:
    bool Exists(const char *) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream *Open(const char *, const char *) override { return nullptr; }
    void Close(Assimp::IOStream *) override {}
};

// The importer of the one format: Assimp would choose others by the file's contents.
void keepImporter(Assimp::Importer &importer, const std::string &format) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        Assimp::BaseImporter *const one = importer.GetImporter(i);
        std::set<std::string> extensions;
        one->GetExtensionList(extensions);
        if (extensions.count(format)) continue;
        importer.UnregisterLoader(one);
        delete one;  // the importer does not own it any more
    }
}

void append(const aiMesh &part, const Vector3 &scale, TriangleMesh &mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D &vertex = part.mVertices[i];
        mesh.vertices.push_back(static_cast<float>(vertex.x * scale.x));
        mesh.vertices.push_back(static_cast<float>(vertex.y * scale.y));
        mesh.vertices.push_back(static_cast<float>(vertex.z * scale.z));
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace &face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines touch nothing
        for (unsigned corner = 0; corner < 3; ++corner) {
            if (face.mIndices[corner] >= part.mNumVertices)
                throw MeshFault("holds a triangle without vertices");
            mesh.triangles.push_back(first + face.mIndices[corner]);
        }
    }
}

TriangleMesh readMesh(const std::string &file, const Vector3 &scale) {
    if (const std::string wrong = whyNotReadable(file, longestMeshFile); !wrong.empty())
        throw MeshFault(wrong);
    const std::string extension = extensionOf(file);
    const auto format = formats().find(extension);
    if (format == formats().end()) throw MeshFault("is none of .dae, .obj and .stl: not supported");
    std::string bytes;
    if (!readBytes(file, bytes)) throw MeshFault("cannot be read");
    const std::string text = format->second(std::move(bytes));

    Assimp::Importer importer;
    keepImporter(importer, extension.substr(1));
    importer.SetIOHandler(new NoFiles);  // owned by the importer
    // Coordinates stay as they are in the file, whichever axis it calls up.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const aiScene *scene = importer.ReadFileFromMemory(
        text.data(), text.size(),
        aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices,
        extension.c_str() + 1);
    if (!scene) throw MeshFault(support::shortened(importer.GetErrorString()));

    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], scale, mesh);
    if (mesh.triangles.empty()) throw MeshFault("holds no triangles");
    for (const float coordinate : mesh.vertices)
        if (!std::isfinite(coordinate)) throw MeshFault("holds a coordinate that is not finite");
    return mesh;
}

}  // namespace

TriangleMesh readMeshFile(const std::string &file, const Vector3 &scale,
                          const Place &place) {
    try {
        return readMesh(file, scale);
    } catch (const MeshFault &fault) {
        throw LoadError(LoadError::Kind::Resource, place, "mesh file " + file + ": " + fault.what());
    }
}

}  // namespace worlds
