#include "loader/read/mesh_file.h"

#include "loader/read/regular_file.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace worlds {

namespace {

LoadError broken(const Place &place, const std::string &file, const std::string &what) {
    return LoadError(LoadError::Kind::Resource, place, "mesh file " + file + ": " + what);
}

constexpr std::uintmax_t longestMeshFile = 1u << 30;  // bytes

// A mesh names further files, of materials for one, which may be no files either.
class RegularFiles : public Assimp::DefaultIOSystem {
public:
    bool Exists(const char *file) const override { return whyNotReadable(file, longestMeshFile).empty(); }
    Assimp::IOStream *Open(const char *file, const char *mode) override {
        return whyNotReadable(file, longestMeshFile).empty() ? DefaultIOSystem::Open(file, mode) : nullptr;
    }
};

// The importer of PLY files makes room for as many vertices and faces as the file says that it holds.
std::string whyNotPly(const std::string &file) {
    std::ifstream stream(file, std::ios::binary);
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    std::string line;
    if (!std::getline(stream, line) || line.compare(0, 3, "ply") != 0) return "";
    while (std::getline(stream, line) && line.compare(0, 10, "end_header") != 0) {
        std::istringstream words(line);
        std::string element, kind, count;
        words >> element >> kind >> count;
        if (element != "element") continue;
        std::uintmax_t elements = 0;
        const auto [stopped, error] = std::from_chars(count.data(), count.data() + count.size(), elements);
        if (error != std::errc() || elements > size) return "says that it holds " + count + " elements '" + kind + "', more than bytes";
    }
    return "";
}

void append(const aiMesh &part, const ignition::math::Vector3d &scale, TriangleMesh &mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D &vertex = part.mVertices[i];
        mesh.vertices.push_back(static_cast<float>(vertex.x * scale.X()));
        mesh.vertices.push_back(static_cast<float>(vertex.y * scale.Y()));
        mesh.vertices.push_back(static_cast<float>(vertex.z * scale.Z()));
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace &face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines touch nothing
        for (unsigned corner = 0; corner < 3; ++corner)
            mesh.triangles.push_back(first + face.mIndices[corner]);
    }
}

}  // namespace

TriangleMesh readMeshFile(const std::string &file, const ignition::math::Vector3d &scale,
                          const Place &place) {
    const std::string wrong = whyNotReadable(file, longestMeshFile);
    if (!wrong.empty()) throw broken(place, file, wrong);
    const std::string notPly = whyNotPly(file);
    if (!notPly.empty()) throw broken(place, file, notPly);
    Assimp::Importer importer;
    importer.SetIOHandler(new RegularFiles);  // owned by the importer
    // Coordinates stay as they are in the file, whichever axis it calls up.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    const aiScene *scene = importer.ReadFile(
        file, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
    if (!scene) throw broken(place, file, importer.GetErrorString());

    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], scale, mesh);
    if (mesh.triangles.empty()) throw broken(place, file, "holds no triangles");
    for (const float coordinate : mesh.vertices)
        if (!std::isfinite(coordinate)) throw broken(place, file, "holds a coordinate that is not finite");
    return mesh;
}

}  // namespace worlds
