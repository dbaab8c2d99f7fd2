// Geoms that all lie in one place, some of which move: one_place KIND SCENE. Prints, for each call, the number of callbacks and a sum over them
// that depends on their order. one_place_test runs it on Debian's libode8 and on ours.
//
//   spaces        empty spaces in one point, as models without collisions are, and a ball that moves far away
//   spaces_met    the same, and the ball moves through them
//   boxes         boxes in one place, and a ball that moves far away
//   disabled      most of a crowd moves, some of it is disabled, and then one moves
//   destroyed     the same, and some are destroyed
//   lidar         rays that begin in one place and turn, among boxes
//   lidar_bits    the same, and rays do not meet rays
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <ode/ode.h>

#include "numbered_spaces.h"

namespace {

constexpr int kSpaces = 400, kBoxes = 300, kRays = 360, kObstacles = 100, kCalls = 30;

void onNear(void *data, dGeomID a, dGeomID b) {
    static_cast<SeenPairs *>(data)->see(a, b);
    if (dGeomIsSpace(a) != 0 && dGeomIsSpace(b) != 0) dSpaceCollide2(a, b, data, onNear);
}

class Place {
public:
    explicit Place(int kind) : m_space(createSpace(kind)) {}
    ~Place() { dSpaceDestroy(m_space); }
    Place(const Place &) = delete;
    Place &operator=(const Place &) = delete;

    dSpaceID space() const { return m_space; }
    dGeomID add(dGeomID geom) {
        setNumber(geom, ++m_geoms);
        return geom;
    }
    void collide() const {
        SeenPairs seen;
        dSpaceCollide(m_space, &seen, onNear);
        std::printf("%ld %016llx\n", seen.pairs, static_cast<unsigned long long>(seen.sum));
    }

private:
    dSpaceID m_space;
    int m_geoms = 0;
};

template <class Create>
void moveBall(Place &place, int others, bool isFar, Create create) {
    for (int i = 0; i < others; ++i) place.add(create());
    const dGeomID ball = place.add(dCreateSphere(place.space(), dReal(0.3)));
    for (int call = 0; call < kCalls; ++call) {
        dGeomSetPosition(ball, isFar ? 50 + dReal(0.01) * call : std::sin(dReal(call)), 0, 0);
        place.collide();
    }
}

void losePart(Place &place, bool areDestroyed) {
    constexpr int kCrowd = 100, kMany = 80, kLost = 10, kCallsOfMany = 60;
    std::vector<dGeomID> crowd;
    for (int i = 0; i < kCrowd; ++i) crowd.push_back(place.add(dCreateSphere(place.space(), 1)));
    int calls = 0;
    const auto moveAndCollide = [&](int geoms) {
        for (int i = 0; i < geoms; ++i) dGeomSetPosition(crowd[static_cast<std::size_t>(i)], dReal(0.001) * i, dReal(0.001) * ++calls, 0);
        place.collide();
    };
    for (int call = 0; call < kCallsOfMany; ++call) moveAndCollide(kMany);
    for (int i = 0; i < kLost; ++i) {
        (areDestroyed ? dGeomDestroy : dGeomDisable)(crowd.back());
        crowd.pop_back();
    }
    moveAndCollide(kMany);
    for (int call = 0; call < kCalls; ++call) moveAndCollide(1);
}

void turnRays(Place &place, bool haveBits) {
    for (int i = 0; i < kObstacles; ++i) {
        const dGeomID box = place.add(dCreateBox(place.space(), dReal(0.5), dReal(0.5), 1));
        dGeomSetPosition(box, 15 * std::sin(dReal(7 * i)), 15 * std::cos(dReal(3 * i)), dReal(0.5));
    }
    std::vector<dGeomID> rays;
    for (int i = 0; i < kRays; ++i) {
        rays.push_back(place.add(dCreateRay(place.space(), 10)));
        if (!haveBits) continue;
        dGeomSetCategoryBits(rays.back(), 2);
        dGeomSetCollideBits(rays.back(), 1);
    }
    for (int call = 0; call < kCalls; ++call) {
        for (int i = 0; i < kRays; ++i) {
            const dReal angle = 2 * static_cast<dReal>(M_PI) * i / kRays + dReal(0.01) * call;
            dGeomRaySet(rays[static_cast<std::size_t>(i)], dReal(0.02) * call, 0, dReal(0.4), std::cos(angle), std::sin(angle), 0);
        }
        place.collide();
    }
}

}  // namespace

int main(int count, char **arguments) {
    if (count != 3) return 2;
    dInitODE2(0);
    const std::string scene = arguments[2];
    {
        Place place(std::atoi(arguments[1]));
        const dSpaceID space = place.space();
        if (scene == "spaces" || scene == "spaces_met")
            moveBall(place, kSpaces, scene == "spaces", [space] { return reinterpret_cast<dGeomID>(dSimpleSpaceCreate(space)); });
        else if (scene == "boxes")
            moveBall(place, kBoxes, true, [space] { return dCreateBox(space, 1, 1, 1); });
        else if (scene == "disabled" || scene == "destroyed")
            losePart(place, scene == "destroyed");
        else
            turnRays(place, scene == "lidar_bits");
    }
    dCloseODE();
    return 0;
}
