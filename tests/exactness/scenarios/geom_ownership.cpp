#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <algorithm>

namespace exactness {

namespace {

// Geoms that change their bodies between frames, or have none for a while.
class BodiesExchanged : public ManyParts {
public:
    BodiesExchanged(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                const dGeomID geom = createShape(space(), allShapes[(part + i) % 4]);
                carry(geom, origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i});
                m_geoms.push_back(geom);
            }
        });
    }

    void control() override {
        const std::size_t one = 3 * frameNumber() % m_geoms.size(), other = (one + 1) % m_geoms.size();
        if (frameNumber() % 4 == 0) std::swap(m_geoms[one], m_geoms[other]);
        if (frameNumber() % 4 == 1) exchange(m_geoms[one], m_geoms[other]);
        if (frameNumber() % 4 == 2) dGeomSetBody(m_geoms[one], nullptr);
        if (frameNumber() % 8 == 7) giveBodies();
    }

private:
    static void exchange(dGeomID one, dGeomID other) {
        const dBodyID first = dGeomGetBody(one), second = dGeomGetBody(other);
        dGeomSetBody(one, second);
        dGeomSetBody(other, first);
    }

    // To each body without a geom one of the geoms without a body.
    void giveBodies() {
        for (dBodyID body : m_inventory.bodies) {
            if (dBodyGetFirstGeom(body) != nullptr) continue;
            const auto isFree = [](dGeomID geom) { return dGeomGetBody(geom) == nullptr; };
            const auto found = std::find_if(m_geoms.begin(), m_geoms.end(), isFree);
            if (found != m_geoms.end()) dGeomSetBody(*found, body);
        }
    }

    std::vector<dGeomID> m_geoms;
};

// Bodies with ten geoms each, set off from them, in spaces of all kinds, two deep, some in the root space.
// Offsets change, are cleared, and are set in world coordinates.
class ManyGeoms : public ManyParts {
public:
    explicit ManyGeoms(Stepper stepper) : ManyParts(stepper) {
        addGround();
        for (SpaceKind kind : allSpaceKinds) {
            m_spaces.push_back(addSpace(createSpace(kind, space())));
            m_spaces.push_back(addSpace(createSpace(kind, m_spaces.back())));
        }
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 2; ++i)
                addStar(part + i, origin + Vector3{dReal(0.2) * i, 0, dReal(0.7) + dReal(1.1) * i});
        });
    }

    void collide() override {
        m_done.clear();
        ManyParts::collide();
    }

    void control() override {
        const dGeomID geom = m_arms[13 * frameNumber() % m_arms.size()];
        const dReal *place = dGeomGetPosition(geom);
        if (frameNumber() % 5 == 0) dGeomClearOffset(geom);
        if (frameNumber() % 5 == 2) dGeomSetOffsetPosition(geom, 0.3, 0.1, 0.02 * (frameNumber() % 7));
        if (frameNumber() % 5 == 3) dGeomSetOffsetWorldPosition(geom, place[0] + 0.05, place[1], place[2]);
        if (frameNumber() % 5 == 4) dGeomSetPosition(geom, place[0], place[1], place[2] + 0.02);
        note("is set off", dGeomIsOffset(geom));
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        ManyParts::onNearPair(o1, o2);
        for (dGeomID each : {o1, o2}) {
            if (!dGeomIsSpace(each) || std::count(m_done.begin(), m_done.end(), each) > 0) continue;
            m_done.push_back(each);
            collideSpace(reinterpret_cast<dSpaceID>(each));
        }
    }

private:
    void addStar(int number, Vector3 place) {
        const dBodyID body = addBody(place, world());
        for (int i = 0; i < 10; ++i) {
            const std::size_t which = (number + i) % (m_spaces.size() + 1);
            const dSpaceID where = which == m_spaces.size() ? space() : m_spaces[which];
            const dGeomID arm = createShape(where, allShapes[i % 4]);
            dGeomSetBody(arm, body);
            dGeomSetOffsetPosition(arm, 0.1 * (i % 5) - 0.2, 0.15 * (i % 3) - 0.15, 0.05 * (i % 4));
            dQuaternion turn;
            dQFromAxisAndAngle(turn, 0, 1, 0.3, 0.6 * i);
            dGeomSetOffsetQuaternion(arm, turn);
            m_arms.push_back(add(arm));
        }
    }

    std::vector<dSpaceID> m_spaces;
    std::vector<dGeomID> m_arms, m_done;
};

// Geom transforms whose child, place of the child, cleanup and info change between frames; some are empty.
class Transforms : public ManyParts {
public:
    explicit Transforms(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 3; ++i) {
                const dGeomID transform = dCreateGeomTransform(space());
                dGeomTransformSetCleanup(transform, 1);
                dGeomTransformSetInfo(transform, (part + i) % 2);
                dGeomTransformSetGeom(transform, createChild(part + i));
                carry(transform, origin + Vector3{dReal(0.05) * i, 0, dReal(0.5) + dReal(0.7) * i});
                m_transforms.push_back(transform);
            }
        });
    }

    void control() override {
        const int frame = frameNumber();
        const dGeomID transform = m_transforms[5 * frame % m_transforms.size()];
        note("cleanup", dGeomTransformGetCleanup(transform));
        if (frame % 3 == 0) dGeomTransformSetInfo(transform, 1 - dGeomTransformGetInfo(transform));
        if (frame % 4 == 1) replaceChild(transform, createChild(frame));
        if (frame % 10 == 5) replaceChild(transform, nullptr);
        // Upstream takes no notice of a child that moves until the transform moves.
        if (const dGeomID child = dGeomTransformGetGeom(transform))
            dGeomSetPosition(child, 0.1, 0.05 * (frame % 3), 0);
    }

private:
    // The new child has the same kind as before or another one; with cleanup the transform destroys the old one.
    void replaceChild(dGeomID transform, dGeomID child) {
        const bool keepsOld = frameNumber() % 8 == 1;
        const dGeomID old = dGeomTransformGetGeom(transform);
        if (keepsOld) dGeomTransformSetCleanup(transform, 0);
        dGeomTransformSetGeom(transform, child);
        if (keepsOld && old != nullptr) dGeomDestroy(old);
        dGeomTransformSetCleanup(transform, 1);
    }

    static dGeomID createChild(int number) {
        const dGeomID child = createShape(nullptr, allShapes[number % 6]);
        dGeomSetPosition(child, 0.05, 0.02, 0.03);
        dMatrix3 tilt;
        dRFromAxisAndAngle(tilt, 1, 0, 0.2, 0.2 * (number % 5));
        dGeomSetRotation(child, tilt);
        return child;
    }

    std::vector<dGeomID> m_transforms;
};

// Kinematic bodies with many geoms sweep through heaps; they are made dynamic and kinematic again.
class Sweepers : public ManyParts {
public:
    Sweepers(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            addSweeper(origin + Vector3{-1.5, 0, 0.6}, part);
            for (int i = 0; i < 9; ++i) {
                const Vector3 place{dReal(0.45) * (i % 3), dReal(0.5) * (i / 3) - dReal(0.5), 0.3};
                carry(createShape(space(), allShapes[(part + i) % 4]), origin + place);
            }
        });
    }

    void control() override {
        for (std::size_t i = 0; i < m_sweepers.size(); ++i) {
            const bool turnsBack = (frameNumber() + i) % 25 == 0;
            if (turnsBack) dBodySetLinearVel(m_sweepers[i], -dBodyGetLinearVel(m_sweepers[i])[0], 0, 0);
        }
        if (frameNumber() == 20) dBodySetDynamic(m_sweepers[3]);
        if (frameNumber() == 30) dBodySetKinematic(m_sweepers[3]);
    }

private:
    void addSweeper(Vector3 place, int part) {
        const dBodyID body = addBody(place, world());
        for (int i = 0; i < 6; ++i) {
            const dGeomID blade = dCreateBox(space(), 0.1, 0.2, 1);
            dGeomSetBody(blade, body);
            dGeomSetOffsetPosition(blade, 0, 0.3 * i - 0.75, 0);
            add(blade);
        }
        dBodySetKinematic(body);
        dBodySetLinearVel(body, 3 + 0.1 * part, 0, 0);
        dBodySetAngularVel(body, 0, 0, 0.2);
        m_sweepers.push_back(body);
    }

    std::vector<dBodyID> m_sweepers;
};

}  // namespace

void addGeomOwnership(Catalogue &catalogue) {
    constexpr auto oneAtATime = Scenario::Callbacks::oneAtATime, shared = Scenario::Callbacks::shared;
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make), callbacks));
    };
    add("geom_ownership/bodies_exchanged", "geoms change their bodies, or lose them",
        make<BodiesExchanged>(SpaceKind::Hash), shared);
    add("geom_ownership/bodies_exchanged_in_simple", "the same in a simple space",
        make<BodiesExchanged>(SpaceKind::Simple), oneAtATime);
    add("geom_ownership/many_geoms", "bodies with ten geoms in spaces of all kinds, whose offsets change",
        make<ManyGeoms>(), oneAtATime);
    catalogue.back().steps = 70;  // they fall first
    add("geom_ownership/transforms", "geom transforms whose children are exchanged", make<Transforms>(),
        oneAtATime);
    catalogue.back().steps = 70;
    add("geom_ownership/sweepers", "kinematic bodies of six geoms sweep through heaps",
        make<Sweepers>(SpaceKind::Hash), shared);
    add("geom_ownership/sweepers_in_simple", "the same in a simple space", make<Sweepers>(SpaceKind::Simple),
        oneAtATime);
}

}  // namespace exactness
