// Recipes for the functions of collision_trimesh.h.
#include "call_recipes.h"
#include "call_shapes.h"

namespace kept_state {

namespace {

int evenTriangles(dGeomID, dGeomID, int triangle) { return triangle % 2 == 0; }
void noArray(dGeomID, dGeomID, const int *, int) {}
int noRay(dGeomID, dGeomID, int, dReal, dReal) { return 0; }
int firstTriangle(dGeomID, int first, int) { return first; }

dTriMeshDataID dataOf(CallScene &s) { return dGeomTriMeshGetData(s.set().mesh); }

void preprocess(dTriMeshDataID data) {
    dGeomTriMeshDataPreprocess2(data, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
}

// The data of an existing mesh is rebuilt, larger; setting its data again notifies the geom.
template <class Build>
CallRecipe::Call rebuild(Build build) {
    return [build](CallScene &s) {
        const dTriMeshDataID data = dGeomTriMeshDataCreate();
        build(data);
        preprocess(data);
        dGeomTriMeshSetData(s.set().mesh, data);
    };
}

void addBuilders(CallRecipes &r) {
    static const dReal normals[24]{};
    r.push_back({"dGeomTriMeshDataBuildSimple", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildSimple(data, meshVertices(1), 6, meshIndices(), 24);
                 })});
    r.push_back({"dGeomTriMeshDataBuildSimple1", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildSimple1(data, meshVertices(1), 6, meshIndices(), 24, nullptr);
                 })});
    r.push_back({"dGeomTriMeshDataBuildSingle", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildSingle(data, meshVerticesSingle(), 3 * sizeof(float), 6,
                                                 meshIndices(), 24, 3 * sizeof(dTriIndex));
                 })});
    r.push_back({"dGeomTriMeshDataBuildSingle1", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildSingle1(data, meshVerticesSingle(), 3 * sizeof(float), 6,
                                                  meshIndices(), 24, 3 * sizeof(dTriIndex), nullptr);
                 })});
    r.push_back({"dGeomTriMeshDataBuildDouble", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildDouble(data, meshVertices(1), 4 * sizeof(double), 6, meshIndices(),
                                                 24, 3 * sizeof(dTriIndex));
                 })});
    r.push_back({"dGeomTriMeshDataBuildDouble1", rebuild([](dTriMeshDataID data) {
                     dGeomTriMeshDataBuildDouble1(data, meshVertices(1), 4 * sizeof(double), 6, meshIndices(),
                                                  24, 3 * sizeof(dTriIndex), normals);
                 })});
}

void addData(CallRecipes &r) {
    r.push_back(
        {"dGeomTriMeshDataCreate", [](CallScene &) { dGeomTriMeshDataDestroy(dGeomTriMeshDataCreate()); }});
    r.push_back({"dGeomTriMeshDataDestroy", [](CallScene &s) {
                     const dTriMeshDataID old = dataOf(s);
                     dGeomTriMeshSetData(s.set().mesh, createMeshData(1));
                     dGeomTriMeshDataDestroy(old);
                 }});
    r.back().inCollision = false;
    r.push_back({"dGeomTriMeshDataSet",
                 [](CallScene &s) { dGeomTriMeshDataSet(dataOf(s), dTRIMESHDATA_USE_FLAGS, nullptr); }});
    r.push_back({"dGeomTriMeshDataGet2",
                 [](CallScene &s) {
                     dsizeint size = 0;
                     s.tell(dGeomTriMeshDataGet2(dataOf(s), dTRIMESHDATA_FACE_NORMALS, &size) != nullptr);
                 },
                 nullptr, true});
    r.push_back({"dGeomTriMeshDataPreprocess", [](CallScene &s) {
                     const dTriMeshDataID data = dGeomTriMeshDataCreate();
                     dGeomTriMeshDataBuildSimple(data, meshVertices(0), 6, meshIndices(), 24);
                     s.tell(dGeomTriMeshDataPreprocess(data));
                     preprocess(data);
                     dGeomTriMeshSetData(s.set().mesh, data);
                 }});
    r.push_back({"dGeomTriMeshDataPreprocess2", [](CallScene &s) {
                     s.tell(dGeomTriMeshDataPreprocess2(
                         dataOf(s), 1u << dTRIDATAPREPROCESS_BUILD_CONCAVE_EDGES, nullptr));
                 }});
    r.back().inCollision = false;
    r.push_back({"dGeomTriMeshDataGetBuffer",
                 [](CallScene &s) {
                     unsigned char *buffer = nullptr;
                     int size = 0;
                     dGeomTriMeshDataGetBuffer(dataOf(s), &buffer, &size);
                     s.tell(size);
                 },
                 nullptr, true});
    r.push_back({"dGeomTriMeshDataSetBuffer", [](CallScene &s) {
                     unsigned char *buffer = nullptr;
                     int size = 0;
                     dGeomTriMeshDataGetBuffer(dataOf(s), &buffer, &size);
                     dGeomTriMeshDataSetBuffer(dataOf(s), buffer);
                 }});
    r.back().inCollision = false;
    const auto stretch = [](dReal height) {
        return [height](CallScene &s) {
            meshVertices(0);
            static dReal vertices[24];
            const dReal *old = meshVertices(0);
            for (int i = 0; i < 24; ++i) vertices[i] = old[i];
            vertices[18] = height;
            const dTriMeshDataID data = dGeomTriMeshDataCreate();
            dGeomTriMeshDataBuildSimple(data, vertices, 6, meshIndices(), 24);
            preprocess(data);
            dGeomTriMeshSetData(s.set().mesh, data);
            vertices[18] = 2 * height;
            dGeomTriMeshDataUpdate(data);
        };
    };
    r.push_back({"dGeomTriMeshDataUpdate", stretch(0.4), stretch(0.25)});
}

void addSetters(CallRecipes &r) {
    r.push_back({"dGeomTriMeshSetData",
                 [](CallScene &s) { dGeomTriMeshSetData(s.set().mesh, createMeshData(1)); },
                 [](CallScene &s) { dGeomTriMeshSetData(s.set().mesh, createMeshData(0)); }});
    r.push_back({"dCreateTriMesh",
                 [](CallScene &s) {
                     s.adopt(dCreateTriMesh(s.set().space, createMeshData(1), nullptr, nullptr, nullptr));
                     dGeomSetPosition(s.created(), 0.6, 0.5, 0.3);
                 },
                 [](CallScene &s) {
                     const dGeomID geom = s.created();
                     s.drop(geom);
                     dGeomDestroy(geom);
                 }});
    r.push_back({"dGeomTriMeshSetLastTransform", [](CallScene &s) {
                     const dMatrix4 transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.2, 0.3, 1};
                     dGeomTriMeshSetLastTransform(s.set().mesh, transform);
                 }});
    r.push_back({"dGeomTriMeshSetCallback",
                 [](CallScene &s) { dGeomTriMeshSetCallback(s.set().mesh, evenTriangles); },
                 [](CallScene &s) { dGeomTriMeshSetCallback(s.set().mesh, nullptr); }});
    r.push_back({"dGeomTriMeshSetArrayCallback",
                 [](CallScene &s) { dGeomTriMeshSetArrayCallback(s.set().mesh, noArray); },
                 [](CallScene &s) { dGeomTriMeshSetArrayCallback(s.set().mesh, nullptr); }});
    r.push_back({"dGeomTriMeshSetRayCallback",
                 [](CallScene &s) { dGeomTriMeshSetRayCallback(s.set().terrain, noRay); },
                 [](CallScene &s) { dGeomTriMeshSetRayCallback(s.set().terrain, nullptr); }});
    r.push_back({"dGeomTriMeshSetTriMergeCallback",
                 [](CallScene &s) { dGeomTriMeshSetTriMergeCallback(s.set().mesh, firstTriangle); },
                 [](CallScene &s) { dGeomTriMeshSetTriMergeCallback(s.set().mesh, nullptr); }});
    const auto coherent = [](int on) {
        return [on](CallScene &s) {
            for (const int kind : {dSphereClass, dBoxClass, dCapsuleClass})
                dGeomTriMeshEnableTC(s.set().terrain, kind, on);
        };
    };
    r.push_back({"dGeomTriMeshEnableTC", coherent(1), coherent(0)});
    r.push_back(
        {"dGeomTriMeshClearTCCache", [](CallScene &s) { dGeomTriMeshClearTCCache(s.set().terrain); }});
}

void addGetters(CallRecipes &r) {
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    ask("dGeomTriMeshGetLastTransform",
        [](CallScene &s) { s.tell(dGeomTriMeshGetLastTransform(s.set().mesh) != nullptr); });
    ask("dGeomTriMeshGetCallback",
        [](CallScene &s) { s.tell(dGeomTriMeshGetCallback(s.set().mesh) == nullptr); });
    ask("dGeomTriMeshGetArrayCallback",
        [](CallScene &s) { s.tell(dGeomTriMeshGetArrayCallback(s.set().mesh) == nullptr); });
    ask("dGeomTriMeshGetRayCallback",
        [](CallScene &s) { s.tell(dGeomTriMeshGetRayCallback(s.set().mesh) == nullptr); });
    ask("dGeomTriMeshGetTriMergeCallback",
        [](CallScene &s) { s.tell(dGeomTriMeshGetTriMergeCallback(s.set().mesh) == nullptr); });
    ask("dGeomTriMeshGetData", [](CallScene &s) { s.tell(dGeomTriMeshGetData(s.set().mesh) != nullptr); });
    ask("dGeomTriMeshIsTCEnabled",
        [](CallScene &s) { s.tell(dGeomTriMeshIsTCEnabled(s.set().mesh, dBoxClass)); });
    ask("dGeomTriMeshGetTriMeshDataID",
        [](CallScene &s) { s.tell(dGeomTriMeshGetTriMeshDataID(s.set().mesh) != nullptr); });
    ask("dGeomTriMeshGetTriangle", [](CallScene &s) {
        dVector3 a, b, c;
        dGeomTriMeshGetTriangle(s.set().mesh, 3, &a, &b, &c);
        s.tell(a, 3);
        s.tell(c, 3);
    });
    ask("dGeomTriMeshGetPoint", [](CallScene &s) {
        dVector3 point;
        dGeomTriMeshGetPoint(s.set().mesh, 2, 0.2, 0.3, point);
        s.tell(point, 3);
    });
    ask("dGeomTriMeshGetTriangleCount",
        [](CallScene &s) { s.tell(dGeomTriMeshGetTriangleCount(s.set().mesh)); });
}

}  // namespace

void addMeshCalls(CallRecipes &recipes) {
    addBuilders(recipes);
    addData(recipes);
    addSetters(recipes);
    addGetters(recipes);
}

}  // namespace kept_state
