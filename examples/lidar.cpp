// Rays as a lidar: a sensor in a room of boxes measures 180 distances in each of its turns. The rays lie in a space of their own, which
// is collided with the room alone, so that no two rays are compared. Prints the least distance of each turn, in metres.
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int kRays = 180;
constexpr double kRange = 10;  // m
constexpr double kPi = 3.14159265358979323846;

class Lidar {
public:
    explicit Lidar(dSpaceID scene) : m_scene(scene), m_rays(dSimpleSpaceCreate(nullptr)), m_ray(kRays), m_distances(kRays) {
        for (int i = 0; i < kRays; ++i) {
            m_ray[i] = dCreateRay(m_rays, kRange);
            dGeomRaySetClosestHit(m_ray[i], 1);
            dGeomSetData(m_ray[i], &m_distances[i]);
        }
    }
    ~Lidar() { dSpaceDestroy(m_rays); }
    Lidar(const Lidar &) = delete;
    Lidar &operator=(const Lidar &) = delete;

    const std::vector<double> &measure(double x, double y, double z) {
        std::fill(m_distances.begin(), m_distances.end(), kRange);
        for (int i = 0; i < kRays; ++i) {
            const double angle = 2 * kPi * i / kRays;
            dGeomRaySet(m_ray[i], x, y, z, std::cos(angle), std::sin(angle), 0);
        }
        dSpaceCollide2(reinterpret_cast<dGeomID>(m_rays), reinterpret_cast<dGeomID>(m_scene), nullptr, &Lidar::hit);
        return m_distances;
    }

private:
    // Each ray has a place of its own for its result.
    static void hit(void *, dGeomID geom1, dGeomID geom2) {
        const dGeomID ray = dGeomGetClass(geom1) == dRayClass ? geom1 : geom2;
        dContactGeom contact;
        if (dCollide(geom1, geom2, 1, &contact, sizeof contact) == 0) return;
        double &distance = *static_cast<double *>(dGeomGetData(ray));
        distance = std::min<double>(distance, contact.depth);  // of a ray, the distance to the hit
    }

    const dSpaceID m_scene, m_rays;
    std::vector<dGeomID> m_ray;  // dSpaceGetGeom has another order after each move
    std::vector<double> m_distances;
};

dGeomID addBox(dSpaceID space, double x, double y, double width, double length) {
    const dGeomID box = dCreateBox(space, width, length, 2);
    dGeomSetPosition(box, x, y, 1);
    return box;
}

}  // namespace

int main() {
    dInitODE2(0);
    dToggleODE_MT(dODE_MT_AUTO);
    const dSpaceID room = dHashSpaceCreate(nullptr);
    for (const double side : {-6.0, 6.0}) {
        addBox(room, side, 0, 0.2, 12);
        addBox(room, 0, side, 12, 0.2);
    }
    for (int i = 0; i < 40; ++i) addBox(room, -4.5 + 1.0 * (i % 10), -3.0 + 2.0 * (i / 10), 0.3, 0.3);
    {
        Lidar lidar(room);
        for (int turn = 0; turn < 8; ++turn) {
            const std::vector<double> &distances = lidar.measure(-4 + 0.87 * turn, 0.1 * turn - 0.4, 0.5);
            const auto least = std::min_element(distances.begin(), distances.end());
            std::printf("turn %d: %.4f m at %3.0f degrees\n", turn, *least, 360.0 * static_cast<double>(least - distances.begin()) / kRays);
        }
    }
    dSpaceDestroy(room);
    dCloseODE();
}
