#include "additions.h"
#include "crowd.h"

#include <cmath>

namespace exactness {

namespace {

// Sizes from a millimetre to a kilometre: many levels of a hash space, and geoms too large for any.
class SixDecades : public Crowd {
public:
    SixDecades(Stepper stepper, SpaceKind kind, int count) : Crowd(stepper, kind, 3) {
        for (int i = 0; i < count; ++i) {
            const dReal size = std::pow(10, m_dice.between(-3, 3));
            const dGeomID geom = addMember(m_dice.within(std::fmin(3 * size + 1, 40)), size);
            if (size > 10) keepFromContacts(geom);
        }
    }

    void control() override { alternate(); }
};

// Many geoms in one place, to the bit, and many more in the same cell.
class OnePlace : public Crowd {
public:
    OnePlace(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind, 4) {
        for (int i = 0; i < 60; ++i) keepFromContacts(addMember({0.5, 0.5, 0.5}, 0.25));
        for (int i = 0; i < 60; ++i)
            keepFromContacts(addMember(Vector3{0.5, 0.5, 0.5} + m_dice.within(0.4), 0.2));
        for (int i = 0; i < 60; ++i) addMember(Vector3{20, 0, 0} + m_dice.within(1.2), 0.5);
    }

    void control() override { alternate(); }
};

// So far apart that nothing is near anything, but for some that travel together.
class SpreadFar : public Crowd {
public:
    SpreadFar(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind, 5) {
        for (int i = 0; i < 500; ++i) {
            const Vector3 place = m_dice.within(30000);
            addMember(place, 1);
            if (i % 5 == 0) addMember(place + Vector3{0.3, 0.2, 0.1}, 0.7);
        }
    }

    void control() override { alternate(); }
};

// Clusters in every corner of the world, far below zero too, where upstream's hash space loses some pairs.
class FarCorners : public Crowd {
public:
    FarCorners(Stepper stepper, SpaceKind kind, dReal distance) : Crowd(stepper, kind, 6) {
        for (int corner = 0; corner < 27; ++corner) {
            const Vector3 centre{distance * (corner % 3 - 1), distance * (corner / 3 % 3 - 1),
                                 distance * (corner / 9 - 1)};
            for (int i = 0; i < 30; ++i) addMember(centre + m_dice.within(2), m_dice.between(0.2, 1.2));
        }
    }

    void control() override { alternate(); }
};

// Planes, rays of infinite length, infinite boxes and balls and some larger than any level, among small geoms.
class Unbounded : public Crowd {
public:
    Unbounded(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind, 7) {
        addMembers(130, 5, 1);
        for (int i = 0; i < 5; ++i) addGiants(i);
        addMembers(130, 5, 1);
    }

    void control() override {
        alternate();
        if (frameNumber() % 4 == 1) dGeomDisable(m_giants[frameNumber() % m_giants.size()]);
        if (frameNumber() % 4 == 3) dGeomEnable(m_giants[(frameNumber() - 2) % m_giants.size()]);
        if (frameNumber() == 15) dGeomPlaneSetParams(m_giants[0], 0, 0, 1, -1);
    }

private:
    void addGiants(int number) {
        addGiant(dCreatePlane(space(), 0.1 * number, 0.3, 1, -7));
        addGiant(dCreateSphere(space(), dInfinity));
        const dGeomID endless = addGiant(dCreateBox(space(), dInfinity, 1 + number, 2));
        tilt(endless, number);
        tilt(addGiant(dCreateBox(space(), 5000, 3, 1)), number);
        const dGeomID ray = addGiant(dCreateRay(space(), dInfinity));
        dGeomRaySet(ray, number, -6, -6, 0.3, 0.5, 1 - 0.4 * number);
    }

    dGeomID addGiant(dGeomID geom) {
        add(geom);
        dGeomSetCollideBits(geom, ~0ul);
        keepFromContacts(geom);
        m_giants.push_back(geom);
        return geom;
    }

    // No entry of the matrix may be zero: zero times infinity is not a number.
    static void tilt(dGeomID geom, int number) {
        dMatrix3 turn;
        dRFromEulerAngles(turn, 0.3 + 0.1 * number, 0.5, 0.7);
        dGeomSetRotation(geom, turn);
    }

    std::vector<dGeomID> m_giants;
};

}  // namespace

void addCrowdExtremes(Catalogue &catalogue) {
    constexpr auto reentrant = Scenario::Callbacks::reentrant;
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, 24, std::move(make), callbacks));
    };
    add("crowd_extremes/six_decades", "1 mm to 1 km in a hash space", make<SixDecades>(SpaceKind::Hash, 300),
        reentrant);
    add("crowd_extremes/six_decades_in_simple", "1 mm to 1 km in a simple space",
        make<SixDecades>(SpaceKind::Simple, 280));
    add("crowd_extremes/six_decades_in_quad_tree", "1 mm to 1 km in a quad-tree space",
        make<SixDecades>(SpaceKind::QuadTree, 600), reentrant);
    add("crowd_extremes/one_place", "120 geoms in one cell of a hash space, 60 of them in one point",
        make<OnePlace>(SpaceKind::Hash), reentrant);
    add("crowd_extremes/one_place_in_sweep_and_prune", "geoms with equal bounds in a sweep-and-prune space",
        make<OnePlace>(SpaceKind::SweepAndPrune));
    add("crowd_extremes/spread_far", "600 geoms over 60 km", make<SpreadFar>(SpaceKind::Hash));
    add("crowd_extremes/far_corners", "crowds 30 km from zero in all directions, hash space",
        make<FarCorners>(SpaceKind::Hash, dReal(30000)), reentrant);
    add("crowd_extremes/around_zero", "crowds on both sides of zero, hash space",
        make<FarCorners>(SpaceKind::Hash, dReal(2.5)));
    add("crowd_extremes/unbounded", "planes, infinite rays, boxes and balls in a hash space",
        make<Unbounded>(SpaceKind::Hash));
    add("crowd_extremes/unbounded_in_simple", "planes, infinite rays, boxes and balls in a simple space",
        make<Unbounded>(SpaceKind::Simple), reentrant);
    add("crowd_extremes/unbounded_in_quad_tree", "planes, infinite rays, boxes and balls in a quad-tree space",
        make<Unbounded>(SpaceKind::QuadTree), reentrant);
    add("crowd_extremes/unbounded_in_sweep_and_prune", "the same in a sweep-and-prune space",
        make<Unbounded>(SpaceKind::SweepAndPrune));
}

}  // namespace exactness
