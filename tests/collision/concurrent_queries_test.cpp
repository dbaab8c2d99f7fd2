// Rays of several threads of the program ask one space at rest, as planners and lidars do: all get the answers that a
// single thread gets, from every kind of space, from the first query on, also if that is the first to process what has
// changed before.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

struct Kind {
    const char *name;
    dSpaceID (*create)(dSpaceID);
    int perSide;     // geoms
    bool isCleaned;  // before the threads ask
};

void PrintTo(const Kind &kind, std::ostream *out) { *out << kind.name; }

dSpaceID createSweep(dSpaceID parent) { return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XYZ); }
dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {0, 0, 0}, extents = {40, 40, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 5);
}

constexpr int kRays = kThreadSanitizer ? 60 : 400;
constexpr int kThreads = 4;

// A field of shapes of all sorts around the origin; every fourth is in a space of its own kind within the space.
class Field {
public:
    explicit Field(const Kind &kind) : m_space(kind.create(nullptr)), m_inner(kind.create(m_space)) {
        const dReal spacing = dReal(60) / kind.perSide;
        for (int y = 0; y < kind.perSide; ++y)
            for (int x = 0; x < kind.perSide; ++x) {
                const int i = y * kind.perSide + x;
                const dGeomID geom = create(i, i % 4 == 1 ? m_inner : m_space);
                dGeomSetPosition(geom, spacing * (x - kind.perSide / 2), spacing * (y - kind.perSide / 2),
                                 dReal(0.1) * (i % 7));
            }
        if (kind.isCleaned) dSpaceClean(m_space);
    }
    // A mesh is exchanged without a notification of its space: its box has to be queried.
    void exchangeMesh() const {
        dGeomTriMeshSetData(m_mesh, m_meshData);
        dReal box[6];
        dGeomGetAABB(m_mesh, box);
    }

    ~Field() {
        dSpaceDestroy(m_space);
        dGeomTriMeshDataDestroy(m_meshData);
    }
    Field(const Field &) = delete;
    Field &operator=(const Field &) = delete;

    dGeomID geom() const { return reinterpret_cast<dGeomID>(m_space); }

private:
    dGeomID create(int i, dSpaceID space) {
        switch (i % 6) {
        case 0: return dCreateSphere(space, dReal(0.9));
        case 1: return dCreateBox(space, 1, 2, 1);
        case 2: return dCreateCapsule(space, dReal(0.5), 1);
        case 3: return dCreateCylinder(space, dReal(0.7), 2);
        case 4: return m_mesh = dCreateTriMesh(space, m_meshData, nullptr, nullptr, nullptr);
        default: return dCreateConvex(space, kPlanes.data(), 4, kPoints.data(), 4, kPolygons.data());
        }
    }

    static dTriMeshDataID createMeshData() {
        const dTriMeshDataID data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(data, kPoints.data(), 3 * sizeof(dReal), 4, kTriangles.data(), 12,
                                    3 * sizeof(dTriIndex));
        return data;
    }

    static constexpr dReal kSlope = dReal(0.57735026918962576);
    static constexpr std::array<dReal, 12> kPoints{1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    static constexpr std::array<dReal, 16> kPlanes{-kSlope, kSlope, kSlope, kSlope, kSlope, -kSlope, kSlope, kSlope,
                                                   kSlope, kSlope, -kSlope, kSlope, -kSlope, -kSlope, -kSlope, kSlope};
    static constexpr std::array<unsigned, 16> kPolygons{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
    static constexpr std::array<dTriIndex, 12> kTriangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    dTriMeshDataID m_meshData = createMeshData();
    dGeomID m_mesh = nullptr;  // the last one
    dSpaceID m_space, m_inner;
};

// The hits of a ray, in order: the geom and the distance.
struct Hit {
    dGeomID geom;
    dReal distance;
    bool operator==(const Hit &other) const { return geom == other.geom && distance == other.distance; }
};
using Hits = std::vector<Hit>;

void onNear(void *data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, data, onNear);
    dContactGeom contacts[4];
    const int count = dCollide(a, b, 4, contacts, sizeof *contacts);
    for (int i = 0; i < count; ++i)
        static_cast<Hits *>(data)->push_back({dGeomGetClass(a) == dRayClass ? b : a, contacts[i].depth});
}

// What the rays of a thread see, each turned a little further than the one before.
std::vector<Hits> look(dGeomID field) {
    std::vector<Hits> seen(kRays);
    const dGeomID ray = dCreateRay(nullptr, 60);
    for (int i = 0; i < kRays; ++i) {
        const dReal angle = dReal(0.37) * i;
        dGeomRaySet(ray, dReal(0.01) * i, 0, dReal(0.3), std::cos(angle), std::sin(angle), 0);
        dSpaceCollide2(ray, field, &seen[i], onNear);
    }
    dGeomDestroy(ray);
    return seen;
}

class ConcurrentQueries : public testing::TestWithParam<Kind> {
protected:
    void SetUp() override {
        if (kThreadSanitizer && !GetParam().isCleaned)
            GTEST_SKIP() << "upstream's flag that a geom has changed is a plain word, written by one thread and read by others";
    }

    OdeSession session;
};

// Each in a thread of its own, which begin together.
std::vector<std::vector<Hits>> lookFromThreads(dGeomID field) {
    std::vector<std::vector<Hits>> seen(kThreads);
    std::atomic<int> ready{0};
    std::vector<std::thread> askers;
    for (std::vector<Hits> &ofThread : seen)
        askers.emplace_back([&] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            ++ready;
            while (ready < kThreads) std::this_thread::yield();
            ofThread = look(field);
            dCleanupODEAllDataForThread();
        });
    for (std::thread &asker : askers) asker.join();
    return seen;
}

TEST_P(ConcurrentQueries, SeeWhatOneThreadSees) {
    std::size_t hits = 0;
    const int rounds = GetParam().perSide < 10 ? 40 : 5;  // they clean a small one in no time
    for (int round = 0; round < rounds; ++round) {
        const Field field(GetParam());
        const std::vector<std::vector<Hits>> seen = lookFromThreads(field.geom());  // the first query
        const std::vector<Hits> wanted = look(field.geom());
        for (const std::vector<Hits> &ofThread : seen) EXPECT_EQ(ofThread, wanted);
        for (const Hits &ofRay : wanted) hits += ofRay.size();
    }
    EXPECT_GT(hits, 3u * kRays);
}

TEST_P(ConcurrentQueries, SeeItAfterAMeshWasExchanged) {
    const Field field(GetParam());
    const std::vector<Hits> wanted = look(field.geom());
    for (int round = 0; round < 5; ++round) {
        field.exchangeMesh();
        for (const std::vector<Hits> &ofThread : lookFromThreads(field.geom())) EXPECT_EQ(ofThread, wanted);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ConcurrentQueries,
    testing::Values(Kind{"simple", dSimpleSpaceCreate, 24, true}, Kind{"hash", dHashSpaceCreate, 24, true},
                    Kind{"sweep", createSweep, 24, true}, Kind{"quadtree", createQuadTree, 24, true},
                    Kind{"quadtreeSmall", createQuadTree, 9, true},
                    Kind{"simpleSmall", dSimpleSpaceCreate, 5, true}, Kind{"hashSmall", dHashSpaceCreate, 5, true},
                    Kind{"simpleUncleaned", dSimpleSpaceCreate, 24, false},
                    Kind{"hashUncleaned", dHashSpaceCreate, 24, false},
                    Kind{"simpleSmallUncleaned", dSimpleSpaceCreate, 5, false},
                    Kind{"hashSmallUncleaned", dHashSpaceCreate, 5, false},
                    Kind{"simpleMiddlingUncleaned", dSimpleSpaceCreate, 9, false},
                    Kind{"hashMiddlingUncleaned", dHashSpaceCreate, 9, false}),
    [](const auto &info) { return std::string(info.param.name); });

}  // namespace
