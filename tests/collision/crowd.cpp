// More pairs than a space keeps: crowd KIND. Geoms gather in one place, part, and gather again, some at rest, with
// callbacks that collide the space again, enable and disable geoms. Prints, for each call, the number of callbacks and
// a sum over them that depends on their order; then the most memory taken, in megabytes. pair_overflow_test runs it on Debian's
// libode8 and on ours.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include <ode/ode.h>

#include "numbered_spaces.h"

namespace {

constexpr int kGeoms = 1100;           // 604,450 pairs
constexpr int kGeomsOfHashSpace = 3000;  // 4,498,500 pairs

struct Seen : SeenPairs {
    dSpaceID space = nullptr;
    long asksAt = -1;  // the callback that collides the space again
};

void onNear(void *data, dGeomID a, dGeomID b) {
    Seen &seen = *static_cast<Seen *>(data);
    seen.see(a, b);
    if (seen.pairs - 1 != seen.asksAt) return;
    Seen again;
    dSpaceCollide(seen.space, &again, onNear);
    std::printf("again %ld %016llx\n", again.pairs, static_cast<unsigned long long>(again.sum));
}

class Crowd {
public:
    Crowd(dSpaceID space, int geoms) : m_space(space) {
        for (int i = 0; i < geoms; ++i) {
            m_geoms.push_back(dCreateSphere(space, 1));
            setNumber(m_geoms.back(), i);
            dGeomSetCategoryBits(m_geoms.back(), i % 50 == 0 ? 2 : 1);
            dGeomSetCollideBits(m_geoms.back(), 1);
        }
    }

    // Every `stride`-th geom, with `room` between two. Without room they are in one cell of a hash space.
    void place(int stride, dReal room) {
        for (int i = 0; i < count(); i += stride)
            dGeomSetPosition(m_geoms[i], 1.9 + room * (i % 33) + dReal(0.001) * (i % 97), 1.9 + room * (i / 33),
                             1.9 + dReal(0.002) * (i % 89));
    }
    void enableOthers(bool isEnabled) {
        for (int i = 3; i < count(); i += 100) (isEnabled ? dGeomEnable : dGeomDisable)(m_geoms[i]);
    }
    void collide(long asksAt = -1) {
        Seen seen;
        seen.space = m_space;
        seen.asksAt = asksAt;
        dSpaceCollide(m_space, &seen, onNear);
        std::printf("%ld %016llx\n", seen.pairs, static_cast<unsigned long long>(seen.sum));
    }

private:
    int count() const { return static_cast<int>(m_geoms.size()); }

    dSpaceID m_space;
    std::vector<dGeomID> m_geoms;
};

}  // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: crowd KIND\n");
        return 2;
    }
    dInitODE2(0);
    const int kind = std::atoi(argv[1]);
    const dSpaceID space = createSpace(kind);
    Crowd crowd(space, kind == 1 ? kGeomsOfHashSpace : kGeoms);
    for (const dReal room : {dReal(0), dReal(0.01)}) {
        crowd.place(1, 3);  // a field
        crowd.collide();
        crowd.place(2, 0);  // half a crowd
        crowd.collide();
        crowd.place(1, room);
        for (int call = 0; call < 40; ++call) {  // counted again in between
            if (call % 3 == 0) crowd.place(7, room);
            if (call % 10 == 4) crowd.enableOthers(call % 20 == 4);
            crowd.collide(call % 16 == 9 ? 1000 : -1);
        }
        crowd.place(3, 2);  // fewer
        for (int call = 0; call < 40; ++call) crowd.collide();
    }
    dSpaceDestroy(space);
    dCloseODE();
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    std::printf("memory %ld\n", usage.ru_maxrss / 1024);
}
