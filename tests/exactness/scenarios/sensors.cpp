#include "additions.h"
#include "contact_probe.h"
#include "crowd.h"
#include "ground_grid.h"
#include "shapes.h"

#include <cmath>
#include <memory>

namespace exactness {

namespace {

// Rays that are in no space ask a space of many geoms, both ways around. Between two questions of one frame
// the space changes, and is asked again before it has collided.
class RaysAgainstSpace : public Crowd {
public:
    RaysAgainstSpace(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind, 21) {
        addMembers(250, 5, 1);
        for (int i = 0; i < 150; ++i) {
            m_rays.push_back(add(dCreateRay(nullptr, m_dice.between(1, 12))));
            aim(m_rays.back());
            dGeomRaySetClosestHit(m_rays.back(), i % 2);
        }
    }

    void control() override {
        alternate();
        askAll();
        change();
        askAll();
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (dGeomGetClass(o1) != dRayClass && dGeomGetClass(o2) != dRayClass) {
            Crowd::onNearPair(o1, o2);
            return;
        }
        m_probe.collide(o1, o2, 4);
        for (int i = 0; i < m_probe.count(); ++i) m_hits.addReal(m_probe.contact(i).depth);
    }

private:
    void aim(dGeomID ray) {
        const Vector3 from = m_dice.within(6), to = m_dice.within(1);
        dGeomRaySet(ray, from.x, from.y, from.z, to.x, to.y, to.z + 0.01);
    }

    void askAll() {
        for (std::size_t i = 0; i < m_rays.size(); ++i) {
            const dGeomID all = reinterpret_cast<dGeomID>(space());
            if (i % 2 == 0) {
                collideTwo(m_rays[i], all);
            } else {
                collideTwo(all, m_rays[i]);
            }
            if (i % 50 == 49) nudge(m_inventory.geoms[i]);
        }
        note("hits", m_hits.value());
    }

    void change() {
        for (int i = 0; i < 20; ++i) aim(m_rays[m_dice.below(static_cast<int>(m_rays.size()))]);
        for (int i = 0; i < 5; ++i) nudge(m_inventory.geoms[m_dice.below(200)]);
        const int number = m_dice.below(150);
        if (dGeomGetBody(m_inventory.geoms[number]) == nullptr) destroy(m_inventory.geoms[number]);
        addMember(m_dice.within(5), 0.8);
    }

    ContactProbe m_probe;
    std::vector<dGeomID> m_rays;
    OrderSum m_hits;
};

// Every setting of a ray against every shape: first contact, culling, closest hit; without length, without
// end, from inside.
class RaySettings : public ManyParts {
public:
    explicit RaySettings(Stepper stepper) : ManyParts(stepper) {
        const Ground hills{9, 0.15, [](int x, int y) { return waves(x, y) - 0.5; }};
        const auto mesh = std::make_shared<GridMesh>(hills);
        const auto heights = std::make_shared<HeightGrid>(hills, HeightOptions{});
        keep(mesh);
        keep(heights);
        addGround();
        addParts([this](int, Vector3 origin) { addSphere(origin + Vector3{5, 0, 1}, 0.3, 1); });
        for (Shape shape : allShapes) m_targets.push_back(add(createShape(nullptr, shape)));
        m_targets.push_back(add(dCreateTriMesh(nullptr, mesh->data(), nullptr, nullptr, nullptr)));
        m_targets.push_back(add(dCreatePlane(nullptr, 0.1, 0, 1, 0.05)));
        m_heights = add(heights->createGeom(nullptr));
        m_ray = add(dCreateRay(nullptr, 1));
    }

    void control() override {
        for (int number = 0; number < 40; ++number) {
            aim(number);
            for (int settings = 0; settings < 8; ++settings) {
                dGeomRaySetParams(m_ray, settings & 1, settings & 2);
                dGeomRaySetClosestHit(m_ray, settings & 4);
                askTargets();
            }
        }
        int first, cull;
        dGeomRayGetParams(m_ray, &first, &cull);
        note("settings", first + 2 * cull + 4 * dGeomRayGetClosestHit(m_ray));
    }

private:
    void aim(int number) {
        constexpr dReal lengths[] = {0, 0.2, 1, 5, dInfinity};
        const dReal t = 0.4 * number + 0.07 * frameNumber();
        const bool isInside = number % 4 == 0;
        const dReal distance = isInside ? 0.02 : 0.8;
        dGeomRaySetLength(m_ray, lengths[number % 5]);
        dGeomRaySet(m_ray, distance * std::sin(t), distance * std::cos(t), 0.3 * std::sin(3 * t),
                    -std::sin(t + 0.1), -std::cos(t), 0.2 * std::cos(2 * t));
        dVector3 start, direction;
        dGeomRayGet(m_ray, start, direction);
        note("aims at", direction[0]);
    }

    void askTargets() {
        for (dGeomID target : m_targets) ask(target);
        // Upstream's height fields cannot collide with a ray of infinite length: an assertion fails.
        if (dGeomRayGetLength(m_ray) < dInfinity) ask(m_heights);
    }

    void ask(dGeomID target) {
        m_probe.collide(m_ray, target, 8);
        m_probe.tell(m_observer);
    }

    ContactProbe m_probe;
    std::vector<dGeomID> m_targets;
    dGeomID m_heights, m_ray;
};

// Robots with a fan of rays each, that drive among posts.
class CarriedRays : public ManyParts {
public:
    CarriedRays(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 8; ++i)
                addStaticCylinder(origin + Vector3{dReal(i % 4) - 1, dReal(i / 4) * 3 - 1, 0.5}, 0.2, 1);
            addRobot(origin + Vector3{0, 0.5, 0.26}, part);
        });
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const bool isRay1 = dGeomGetClass(o1) == dRayClass, isRay2 = dGeomGetClass(o2) == dRayClass;
        if (isRay1 && isRay2) return;
        if (!isRay1 && !isRay2) {
            ManyParts::onNearPair(o1, o2);
            return;
        }
        dContact hit{};
        if (dCollide(o1, o2, 1, &hit.geom, sizeof(dContact)) > 0) tell(hit);
    }

private:
    void addRobot(Vector3 place, int part) {
        const dBodyID robot = addBox(place, {0.5, 0.4, 0.5}, 5);
        dBodySetLinearVel(robot, 0.5, 0.1 * part, 0);
        dBodySetAngularVel(robot, 0, 0, 2);
        for (int i = 0; i < 24; ++i) {
            const dGeomID ray = dCreateRay(space(), 3);
            dGeomSetBody(ray, robot);
            dQuaternion turn;
            dQFromAxisAndAngle(turn, std::cos(0.26 * i), std::sin(0.26 * i), 0, 1.5);
            dGeomSetOffsetQuaternion(ray, turn);
            dGeomSetOffsetPosition(ray, 0, 0, 0.02 * i);
            add(ray);
        }
    }
};

// Members that ask their own space, many in a row while all are at rest, and callbacks that enable and disable others. Between the frames few
// things change, so that what a space has kept for the questions of one frame is asked in the next.
class AskingMembers : public Crowd {
public:
    AskingMembers(Stepper stepper, SpaceKind kind) : Crowd(stepper, kind, 23) {
        addMembers(kMembers, 5, 1);
        for (int i = 0; i < 40; ++i) keepFromContacts(addMemberWithoutBody(m_dice.within(5), i % 4 == 0 ? 6 : 1));
    }

    void control() override {
        moveEvery(frameNumber() % 6 < 4 ? 0 : 1);
        ask(40);
        change();
        ask(3);
        change();
        ask(20);
        note("what they met", m_met.value());
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (m_isAsking)
            meet(o1, o2);
        else
            Crowd::onNearPair(o1, o2);
    }

private:
    static constexpr int kMembers = 160;

    dGeomID some() { return m_inventory.geoms[m_dice.below(kMembers)]; }

    void ask(int members) {
        m_isAsking = true;
        for (int i = 0; i < members; ++i) collideTwo(some(), reinterpret_cast<dGeomID>(space()));
        m_isAsking = false;
    }

    void meet(dGeomID o1, dGeomID o2) {
        for (const dGeomID geom : {o1, o2}) m_met.addReal(dGeomGetPosition(geom)[0]);
        ++m_meetings;
        if (m_meetings % 31 == 0) dGeomDisable(some());
        if (m_meetings % 29 == 0) dGeomEnable(some());
        if (m_meetings % 53 == 0) collideTwo(o2, reinterpret_cast<dGeomID>(space()));
    }

    void change() {
        switch (frameNumber() % 5) {
        case 0: dGeomSetCategoryBits(some(), 1ul << frameNumber() % 3); break;
        case 1: nudge(some()); break;
        case 2: dGeomEnable(some()); break;
        case 3: dGeomDisable(some()); break;
        default:
            const dGeomID geom = some();
            dSpaceRemove(space(), geom);
            dSpaceAdd(space(), geom);
        }
    }

    OrderSum m_met;
    int m_meetings = 0;
    bool m_isAsking = false;
};

// Volumes in a space of their own that are asked from within the callbacks of the world's space, and that ask
// in turn what is in them.
class Volumes : public Crowd {
public:
    explicit Volumes(Stepper stepper)
        : Crowd(stepper, SpaceKind::Hash, 22), m_volumes(dSimpleSpaceCreate(nullptr)) {
        addMembers(300, 5, 1);
        m_inventory.spaces.push_back(m_volumes);  // not one that collide() goes through
        for (int i = 0; i < 30; ++i) {
            const dGeomID volume =
                add(i % 2 == 0 ? dCreateSphere(m_volumes, 1) : dCreateBox(m_volumes, 1, 2, 1));
            const Vector3 place = m_dice.within(5);
            dGeomSetPosition(volume, place.x, place.y, place.z);
        }
    }

    ~Volumes() override { destroyVolumes(); }

    void control() override {
        alternate();
        for (int i = 0; i < 6; ++i) {
            const dGeomID volume = dSpaceGetGeom(m_volumes, (5 * i + frameNumber()) % 30);
            nudge(volume);
            collideTwo(volume, reinterpret_cast<dGeomID>(space()));
        }
        note("what was in them", m_seen.value());
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (isVolume(o1) || isVolume(o2)) {
            m_seen.add(dCollide(o1, o2, 1, &m_contact, sizeof(m_contact)));
            m_seen.addReal(m_contact.depth);
            return;
        }
        Crowd::onNearPair(o1, o2);
        if (m_pairs++ % 5 != 0) return;
        collideTwo(o1, reinterpret_cast<dGeomID>(m_volumes));
        collideTwo(reinterpret_cast<dGeomID>(m_volumes), o2);
        if (m_pairs % 3 == 0) nudge(dSpaceGetGeom(m_volumes, m_pairs % 30));
    }

private:
    bool isVolume(dGeomID geom) const { return dGeomGetSpace(geom) == m_volumes; }

    void destroyVolumes() {
        m_inventory.geoms.resize(m_inventory.geoms.size() - 30);
        dSpaceDestroy(m_volumes);
    }

    dSpaceID m_volumes;
    dContactGeom m_contact{};
    OrderSum m_seen;
    int m_pairs = 0;
};

}  // namespace

void addSensors(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, 16, std::move(make), callbacks));
    };
    add("sensors/rays_against_simple", "150 rays query a simple space, changed between queries",
        make<RaysAgainstSpace>(SpaceKind::Simple));
    add("sensors/rays_against_hash", "150 rays query a hash space, changed between queries",
        make<RaysAgainstSpace>(SpaceKind::Hash));
    add("sensors/rays_against_sweep_and_prune", "150 rays query a sweep-and-prune space",
        make<RaysAgainstSpace>(SpaceKind::SweepAndPrune));
    add("sensors/rays_against_quad_tree", "150 rays query a quad-tree space",
        make<RaysAgainstSpace>(SpaceKind::QuadTree));
    add("sensors/members_of_simple", "members of a simple space ask what they meet in it", make<AskingMembers>(SpaceKind::Simple));
    add("sensors/members_of_hash", "the same in a hash space", make<AskingMembers>(SpaceKind::Hash));
    add("sensors/members_of_sweep_and_prune", "the same in a sweep-and-prune space", make<AskingMembers>(SpaceKind::SweepAndPrune));
    add("sensors/members_of_quad_tree", "the same in a quad-tree space", make<AskingMembers>(SpaceKind::QuadTree));
    add("sensors/ray_settings", "every setting of rays against every class of geoms", make<RaySettings>());
    add("sensors/carried_rays", "robots with fans of rays among posts", make<CarriedRays>(SpaceKind::Hash),
        Scenario::Callbacks::shared);
    add("sensors/volumes", "volumes queried from within callbacks of another space", make<Volumes>());
}

}  // namespace exactness
