// One engine of bench/spaces/grid: collides spaces as cells of the grid describe them, one a line of standard input, on the libode that it finds.
//
//   KIND GEOMS CROWDING MOVED MOTION FILTER RAYS NESTED QUERIES ASKERS CALLS
//
//   KIND      0 simple, 1 hash, 2 sweep and prune, 3 quad tree
//   CROWDING  number of boxes that a box overlaps on average; -1: all are in one place
//   MOVED     share of the geoms that move before each call, in thousandths; -1: one geom alone
//   MOTION    0: each by a tenth of its size; 1: each to any place; 2: as 0, but for five calls nothing moves, then for five
//   FILTER    0: every geom may meet every other; 1: half of them meet the other half alone; 2: as 0, and the category bits of one change before each
//             call
//   RAYS      share of rays among the geoms, in hundredths
//   NESTED    0: all geoms are in the space; N: in simple spaces of N geoms within it, which are collided with one another
//   QUERIES   0: a call is one of dSpaceCollide; N: it is N of dSpaceCollide2, or one with a space of N
//   ASKERS    of these queries: 0: one ray, as a lidar casts it, with dCollide in the callbacks; 1: members of the space, one after the other; 2: a
//             space of the same kind with boxes that all move
//
// For each it answers with the time of a call, and of moving the geoms before it, in microseconds of the thread's processor time (the median of eight
// parts of the calls); with the number of callbacks of the last call; and with a hash of all callbacks of the first twelve calls in their order. A
// line that describes the same space as the one before goes on with it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include <ode/ode.h>
#include <time.h>

namespace {

constexpr int kParts = 8, kHashedCalls = 12;

double now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

struct Cell {
    int kind, geoms, crowding, moved, motion, filter, rays, nested, queries, askers, calls;

    bool isSameScene(const Cell &other) const {
        return kind == other.kind && geoms == other.geoms && crowding == other.crowding && moved == other.moved && motion == other.motion &&
               filter == other.filter && rays == other.rays && nested == other.nested && queries == other.queries && askers == other.askers;
    }
};

class Random {
public:
    double between(double low, double high) {
        m_state = m_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        return low + (high - low) * static_cast<double>(m_state >> 11) * 0x1p-53;
    }

private:
    std::uint64_t m_state = 1;
};

struct Seen {
    long callbacks = 0;
    bool isHashed = false;
    std::uint64_t hash = 0;
};

void onNear(void *data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) return dSpaceCollide2(a, b, data, onNear);
    Seen &seen = *static_cast<Seen *>(data);
    ++seen.callbacks;
    if (!seen.isHashed) return;
    for (const dGeomID geom : {a, b})
        seen.hash = (seen.hash ^ reinterpret_cast<std::uintptr_t>(dGeomGetData(geom))) * UINT64_C(1099511628211);
}

// Of a ray.
void onHit(void *data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) return dSpaceCollide2(a, b, data, onHit);
    dContactGeom contact;
    const int contacts = dCollide(a, b, 1, &contact, sizeof contact);
    if (contacts != 0) onNear(data, a, b);
}

class Scene {
public:
    explicit Scene(const Cell &cell) : m_cell(cell) {
        dSpaceID into = m_space;
        for (int i = 0; i < cell.geoms; ++i) {
            if (cell.nested != 0 && i % cell.nested == 0) into = dSimpleSpaceCreate(m_space);
            const bool isRay = i * cell.rays / 100 != (i + 1) * cell.rays / 100;
            const dGeomID geom = isRay ? dCreateRay(into, 1.5) : dCreateBox(into, 1, 1, 1);
            dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::uintptr_t>(i)));
            if (cell.filter == 1) {
                dGeomSetCategoryBits(geom, i % 2 == 0 ? 1 : 2);
                dGeomSetCollideBits(geom, i % 2 == 0 ? 2 : 1);
            }
            m_geoms.push_back(geom);
            place(geom);
        }
        for (int i = 0; cell.askers == 2 && i < cell.queries; ++i) {
            m_visitors.push_back(dCreateBox(m_visiting, 1, 1, 1));
            dGeomSetData(m_visitors.back(), reinterpret_cast<void *>(static_cast<std::uintptr_t>(cell.geoms + i)));
            place(m_visitors.back());
        }
    }
    ~Scene() {
        dGeomDestroy(m_ray);
        dSpaceDestroy(m_visiting);
        dSpaceDestroy(m_space);
    }
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    const Cell &cell() const { return m_cell; }

    void call(Seen &seen) {
        if (m_cell.motion != 2 || m_calls / 5 % 2 == 1) move();
        if (m_cell.filter == 2) dGeomSetCategoryBits(m_geoms[m_calls % m_geoms.size()], 1 + m_calls / m_geoms.size() % 2);
        ++m_calls;
        if (m_cell.queries == 0)
            dSpaceCollide(m_space, &seen, onNear);
        else if (m_cell.askers == 0)
            castRays(seen);
        else if (m_cell.askers == 1)
            askMembers(seen);
        else
            visit(seen);
    }

private:
    dSpaceID makeSpace() const {
        const dVector3 centre = {0, 0, 0, 0}, extents = {edge() / 2, edge() / 2, edge() / 2, 0};
        switch (m_cell.kind) {
        case 0: return dSimpleSpaceCreate(nullptr);
        case 1: return dHashSpaceCreate(nullptr);
        case 2: return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
        default: return dQuadTreeSpaceCreate(nullptr, centre, extents, 5);
        }
    }
    // Of the cube in which `geoms` boxes of edge 1 overlap `crowding` others each.
    double edge() const {
        if (m_cell.crowding < 0) return 0.25;
        return std::cbrt(8.0 * m_cell.geoms / std::max(m_cell.crowding, 1));
    }
    void place(dGeomID geom) {
        const double half = edge() / 2;
        const double x = m_random.between(-half, half), y = m_random.between(-half, half), z = m_random.between(-half, half);
        dGeomSetPosition(geom, static_cast<dReal>(x), static_cast<dReal>(y), static_cast<dReal>(z));
    }
    void shift(dGeomID geom) {
        const dReal *position = dGeomGetPosition(geom);
        double moved[3];
        for (int axis = 0; axis < 3; ++axis) moved[axis] = position[axis] * 0.999 + m_random.between(-0.1, 0.1);
        dGeomSetPosition(geom, static_cast<dReal>(moved[0]), static_cast<dReal>(moved[1]), static_cast<dReal>(moved[2]));
    }
    // From the middle, all around.
    void castRays(Seen &seen) {
        for (int i = 0; i < m_cell.queries; ++i) {
            const double angle = 2 * M_PI * i / m_cell.queries;
            dGeomRaySet(m_ray, 0, 0, 0, static_cast<dReal>(std::cos(angle)), static_cast<dReal>(std::sin(angle)), dReal(0.1));
            dSpaceCollide2(m_ray, reinterpret_cast<dGeomID>(m_space), &seen, onHit);
        }
    }
    void askMembers(Seen &seen) {
        for (int i = 0; i < m_cell.queries; ++i)
            dSpaceCollide2(m_geoms[m_asked++ % m_geoms.size()], reinterpret_cast<dGeomID>(m_space), &seen, onNear);
    }
    void visit(Seen &seen) {
        for (const dGeomID visitor : m_visitors) shift(visitor);
        dSpaceCollide2(reinterpret_cast<dGeomID>(m_visiting), reinterpret_cast<dGeomID>(m_space), &seen, onNear);
    }
    void move() {
        const auto count = static_cast<std::size_t>(m_cell.moved < 0 ? 1 : m_cell.geoms * m_cell.moved / 1000);
        for (std::size_t i = 0; i < count; ++i) m_cell.motion == 0 ? shift(m_geoms[i]) : place(m_geoms[i]);
    }

    Cell m_cell;
    Random m_random;
    dSpaceID m_space = makeSpace(), m_visiting = makeSpace();
    dGeomID m_ray = dCreateRay(nullptr, 10);
    std::vector<dGeomID> m_geoms, m_visitors;
    std::size_t m_calls = 0, m_asked = 0;
};

}  // namespace

int main() {
    dInitODE2(0);
    std::unique_ptr<Scene> scene;
    std::uint64_t hash = 0;
    int hashedCalls = 0;
    for (Cell cell; std::scanf("%d %d %d %d %d %d %d %d %d %d %d", &cell.kind, &cell.geoms, &cell.crowding, &cell.moved, &cell.motion, &cell.filter,
                               &cell.rays, &cell.nested, &cell.queries, &cell.askers, &cell.calls) == 11;) {
        if (scene == nullptr || !scene->cell().isSameScene(cell)) {
            scene = std::make_unique<Scene>(cell);
            hash = hashedCalls = 0;
        }
        std::vector<double> times;
        Seen seen;
        for (int part = 0; part < kParts; ++part) {
            const double begin = now();
            const int calls = (part + 1) * cell.calls / kParts - part * cell.calls / kParts;
            for (int call = 0; call < calls; ++call) {
                seen.callbacks = 0;
                seen.isHashed = hashedCalls < kHashedCalls;
                seen.hash = hash;
                scene->call(seen);
                if (!seen.isHashed) continue;
                hash = seen.hash;
                ++hashedCalls;
            }
            if (calls != 0) times.push_back((now() - begin) / calls);
        }
        std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
        std::printf("%.3f %ld %016llx\n", times.empty() ? 0.0 : times[times.size() / 2], seen.callbacks,
                    static_cast<unsigned long long>(hash));
        std::fflush(stdout);
    }
    scene.reset();
    dCloseODE();
    return 0;
}
