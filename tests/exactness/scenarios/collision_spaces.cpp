#include "additions.h"
#include "scenario_scene.h"
#include "spaces.h"

namespace exactness {

namespace {

// Heaps that tumble apart, in a space of the given kind.
class Heaps : public ManyParts {
public:
    Heaps(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            // Below, beside and above zero: cells of the hash space with negative numbers too.
            const Vector3 corner = origin + Vector3{-35, -35, 0};
            for (int i = 0; i < 9; ++i)
                addPiece(part, i, corner + Vector3{dReal(0.1) * (i % 2), 0, dReal(0.3) + dReal(0.42) * i});
        });
    }

private:
    void addPiece(int part, int i, Vector3 place) {
        if ((part + i) % 2 == 0) {
            addBox(place, {0.5, 0.4, 0.4}, 1);
        } else {
            addSphere(place, 0.2 + 0.005 * i, 1);
        }
    }
};

// A hash space with few levels, so that small geoms lie in cells too big for them and big ones in none.
class HashLevels : public Heaps {
public:
    explicit HashLevels(Stepper stepper) : Heaps(stepper, SpaceKind::Hash) {
        dHashSpaceSetLevels(space(), -1, 1);
        addBox({0, 0, 6}, {30, 0.5, 0.5}, 50);
    }
};

// Spaces of every kind within the root space, and a space within each of them. The bodies of a part have
// one geom in either.
class NestedSpaces : public ManyParts {
public:
    NestedSpaces(Stepper stepper, SpaceKind root) : ManyParts(stepper, root) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            const dSpaceID outer = addSpace(createSpace(allSpaceKinds[part % 4], space()));
            const dSpaceID inner = addSpace(createSpace(allSpaceKinds[part / 4 % 4], outer));
            dSpaceSetSublevel(inner, 1);
            for (int i = 0; i < 6; ++i)
                addPiece(origin + Vector3{dReal(0.05) * i, 0, dReal(0.4) + dReal(0.5) * i}, outer, inner);
        });
    }

    void collide() override {
        m_done.clear();
        ManyParts::collide();
    }

protected:
    // The callback collides spaces with one another, and each with itself.
    void onNearPair(dGeomID o1, dGeomID o2) override {
        ManyParts::onNearPair(o1, o2);
        if (dGeomIsSpace(o1)) collideOnce(o1);
        if (dGeomIsSpace(o2)) collideOnce(o2);
    }

private:
    void addPiece(Vector3 place, dSpaceID outer, dSpaceID inner) {
        const dBodyID body = addBody(place, world());
        const dGeomID box = dCreateBox(outer, 0.5, 0.3, 0.3), knob = dCreateSphere(inner, 0.18);
        for (dGeomID geom : {box, knob}) {
            dGeomSetBody(geom, body);
            add(geom);
        }
        dGeomSetOffsetPosition(knob, 0.2, 0.1, 0.1);
    }

    void collideOnce(dGeomID which) {
        for (dGeomID done : m_done) {
            if (done == which) return;
        }
        m_done.push_back(which);
        collideSpace(reinterpret_cast<dSpaceID>(which));
    }

    std::vector<dGeomID> m_done;
};

}  // namespace

void addCollisionSpaces(Catalogue &catalogue) {
    catalogue.push_back(
        {"collision_spaces/simple", "heaps in a simple space", 80, make<Heaps>(SpaceKind::Simple)});
    catalogue.push_back({"collision_spaces/hash", "heaps in a hash space, at negative cells too", 80,
                         make<Heaps>(SpaceKind::Hash)});
    catalogue.push_back(
        {"collision_spaces/hash_levels", "heaps in a hash space of three levels", 80, make<HashLevels>()});
    catalogue.push_back({"collision_spaces/sweep_and_prune", "heaps in a sweep-and-prune space", 80,
                         make<Heaps>(SpaceKind::SweepAndPrune)});
    catalogue.push_back(
        {"collision_spaces/quad_tree", "heaps in a quad-tree space", 80, make<Heaps>(SpaceKind::QuadTree)});
    catalogue.push_back({"collision_spaces/nested", "spaces of all kinds, three deep, in a hash space", 60,
                         make<NestedSpaces>(SpaceKind::Hash)});
    catalogue.push_back({"collision_spaces/nested_in_sweep_and_prune",
                         "spaces of all kinds in a sweep-and-prune space", 60,
                         make<NestedSpaces>(SpaceKind::SweepAndPrune)});
    catalogue.push_back({"collision_spaces/nested_in_quad_tree", "spaces of all kinds in a quad-tree space", 60,
                         make<NestedSpaces>(SpaceKind::QuadTree)});
}

}  // namespace exactness
