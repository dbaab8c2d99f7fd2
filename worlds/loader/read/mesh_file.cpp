#include "loader/read/mesh_file.h"

#include "loader/read/collada_file.h"
#include "loader/read/mesh_check.h"
#include "loader/read/regular_file.h"
#include "support/text.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <assimp/IOSystem.hpp>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace worlds {

namespace {

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
