// Geoms that are clean when they are added are in front of dirty ones: clean_before_dirty HASH MOVED ADDED, the
// latter two as sets of bits over six geoms. Prints the callbacks. clean_before_dirty_test runs it on Debian's
// libode8 and on ours.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <ode/ode.h>

namespace {

constexpr int kGeoms = 6;

void print(void *, dGeomID a, dGeomID b) {
    const auto number = [](dGeomID geom) { return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); };
    std::printf(" %d-%d", number(a), number(b));
    std::fflush(stdout);  // the library may abort next
}

void collide(dSpaceID space) {
    std::printf("collide:");
    dSpaceCollide(space, nullptr, print);
    std::printf("\n");
}

}  // namespace

int main(int argc, char **argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: clean_before_dirty HASH MOVED ADDED\n");
        return 2;
    }
    const int moved = std::atoi(argv[2]), added = std::atoi(argv[3]);
    dInitODE2(0);
    const dSpaceID space = std::atoi(argv[1]) != 0 ? dHashSpaceCreate(nullptr) : dSimpleSpaceCreate(nullptr);
    dGeomID geoms[kGeoms];
    for (int i = 0; i < kGeoms; ++i) {
        geoms[i] = dCreateSphere(space, 1);
        dGeomSetData(geoms[i], reinterpret_cast<void *>(static_cast<std::intptr_t>(i)));
        dGeomSetPosition(geoms[i], i % 2, i / 2 * 1000, 0);  // three pairs, far from each other
    }
    collide(space);
    for (int i = 0; i < kGeoms; ++i)
        if ((moved >> i & 1) != 0) dGeomSetPosition(geoms[i], i % 2 + dReal(0.1), i / 2 * 1000, 0);
    for (int i = 0; i < kGeoms; ++i) {
        if ((added >> i & 1) == 0) continue;
        dSpaceRemove(space, geoms[i]);
        dSpaceAdd(space, geoms[i]);
    }
    collide(space);
    collide(space);
    for (const dGeomID geom : geoms) dGeomSetPosition(geom, 0, 0, 0);
    collide(space);
    dSpaceDestroy(space);
    dCloseODE();
}
