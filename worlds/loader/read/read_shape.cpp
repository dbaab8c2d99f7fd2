#include "loader/read/read_shape.h"

#include "loader/read/height_image.h"
#include "loader/read/mesh_file.h"

#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Heightmap.hh>
#include <sdf/Mesh.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>

namespace worlds {

namespace {

std::string findResource(const std::string &uri, const Place &place, const Reading &reading) {
    const std::string file = reading.resources.find(uri, place.file);
    if (file.empty()) throw LoadError(LoadError::Kind::Resource, place, "no file " + quote(uri));
    return file;
}

Shape readPlane(const sdf::Plane &plane) {
    return Plane{plane.Normal()};  // libsdformat keeps it at length 1
}

Shape readMesh(const sdf::Mesh &mesh, const Reading &reading) {
    const Place place = reading.place(mesh.Element());
    return readMeshFile(findResource(mesh.Uri(), place, reading), mesh.Scale(), place);
}

Shape readHeightmap(const sdf::Heightmap &heightmap, const Reading &reading) {
    const Place place = reading.place(heightmap.Element());
    return readHeightImage(findResource(heightmap.Uri(), place, reading), heightmap.Size(), place);
}

}  // namespace

std::optional<Shape> readShape(const sdf::Geometry &geometry, bool isStatic, const Reading &reading) {
    switch (geometry.Type()) {
        case sdf::GeometryType::BOX:
            return Box{geometry.BoxShape()->Size()};
        case sdf::GeometryType::SPHERE:
            return Sphere{geometry.SphereShape()->Radius()};
        case sdf::GeometryType::CYLINDER:
            return Cylinder{geometry.CylinderShape()->Radius(), geometry.CylinderShape()->Length()};
        case sdf::GeometryType::CAPSULE:
            return Capsule{geometry.CapsuleShape()->Radius(), geometry.CapsuleShape()->Length()};
        case sdf::GeometryType::MESH:
            return readMesh(*geometry.MeshShape(), reading);
        case sdf::GeometryType::PLANE:
            if (isStatic) return readPlane(*geometry.PlaneShape());
            break;
        case sdf::GeometryType::HEIGHTMAP:
            if (isStatic) return readHeightmap(*geometry.HeightmapShape(), reading);
            break;
        default:  // checkElements has named it
            return std::nullopt;
    }
    reading.issues.unsupported(reading.place(geometry.Element()), "a shape without end on a body that moves");
    return std::nullopt;
}

ignition::math::Vector3d shapeOffset(const sdf::Geometry &geometry) {
    return geometry.Type() == sdf::GeometryType::HEIGHTMAP ? geometry.HeightmapShape()->Position()
                                                           : ignition::math::Vector3d::Zero;
}

}  // namespace worlds
