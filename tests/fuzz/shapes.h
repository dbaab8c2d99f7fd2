// Meshes, height fields, convex geoms and a class of geoms of the program's: their arrays, to which a script may write at any
// time, and their callbacks.
#pragma once

#include <ode/ode.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace fuzz {

// Which callback of the program's ODE has called; the player makes its calls there.
enum class ShapeCallback { collider, box, triangle, height };
extern std::function<void(ShapeCallback)> shapeCallback;

// Arrays live as long as the process.
class Shapes {
public:
    enum class Builder { simple, simple1, single, single1, doubles, doubles1 };

    // A mesh: 0 an octahedron, 1 a terrain, 2 a box, 3 a lone triangle. `size` of its edges.
    dTriMeshDataID makeMesh(Builder builder, int shape, double size);
    void writeVertex(dTriMeshDataID data, int vertex, int axis, double value) const;
    void preprocess(dTriMeshDataID data, unsigned flags) const;

    enum class Samples { bytes, shorts, floats, doubles, callback };
    struct Field {
        bool isCopied, isWrapped;
        double scale, offset, thickness;
    };
    dHeightfieldDataID makeField();
    void buildField(dHeightfieldDataID data, Samples samples, const Field &field);
    void writeHeight(dHeightfieldDataID data, int sample, double value) const;

    // A convex geom: 0 a cube, 1 a longer box, 2 a tetrahedron.
    dGeomID makeConvex(dSpaceID space, int shape);
    void setConvex(dGeomID geom, int shape) const;
    void writeConvexPoint(int shape, int point, int axis, double value) const;

    // A ball of the program's class; `tested`: the class has a test of boxes.
    dGeomID makeBall(dSpaceID space, double radius, bool tested);

private:
    struct Mesh {
        std::vector<double> vertices, padded;
        std::vector<float> singles;
        std::vector<dTriIndex> indices;
        std::vector<double> normals;
        std::vector<float> singleNormals;
    };
    struct Heights {
        std::vector<double> doubles;
        std::vector<float> floats;
        std::vector<short> shorts;
        std::vector<unsigned char> bytes;
    };

    std::map<dTriMeshDataID, std::unique_ptr<Mesh>> m_meshes;
    std::map<dHeightfieldDataID, std::unique_ptr<Heights>> m_fields;
};

// Callbacks for meshes.
int keepsEvenTriangles(dGeomID mesh, dGeomID other, int triangle);
void seesTriangles(dGeomID mesh, dGeomID other, const int *triangles, int count);
int stopsRaysAtOddTriangles(dGeomID mesh, dGeomID ray, int triangle, dReal u, dReal v);
int mergesToTheFirst(dGeomID mesh, int first, int second);

}  // namespace fuzz
