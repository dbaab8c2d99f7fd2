#include "additions.h"
#include "contact_probe.h"
#include "ground_grid.h"
#include "prism.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <memory>

namespace exactness {

namespace {

// Heaps of prisms with three to eight corners.
class Prisms : public ManyParts {
protected:
    Prisms(Stepper stepper, SpaceKind kind = SpaceKind::Hash) : ManyParts(stepper, kind) {
        for (int corners = 3; corners <= 8; ++corners) {
            m_prisms.push_back(std::make_shared<Prism>(corners, dReal(0.3), dReal(0.4)));
            keep(m_prisms.back());
        }
    }

    dGeomID createPrism(int number) const { return m_prisms[number % m_prisms.size()]->createGeom(space()); }

    void drop(dGeomID geom, Vector3 place, int number) {
        dBodySetAngularVel(carry(geom, place), 0.3, 0.1 * (number % 4), 0.2);
    }

    std::vector<std::shared_ptr<Prism>> m_prisms;
};

// Prisms on one another, or with every other shape between them, on a plane.
class Heaps : public Prisms {
public:
    Heaps(Stepper stepper, SpaceKind kind, bool isMixed) : Prisms(stepper, kind) {
        addGround();
        addParts([this, isMixed](int part, Vector3 origin) {
            for (int i = 0; i < 6; ++i) {
                const bool isOther = isMixed && i % 2 == 1;
                const dGeomID geom =
                    isOther ? createShape(space(), allShapes[(part + i / 2) % 6]) : createPrism(part + i);
                drop(geom,
                     origin + Vector3{dReal(0.05) * (i % 3), dReal(0.03) * i, dReal(0.3) + dReal(0.5) * i},
                     i);
            }
        });
    }
};

// Prisms on a mesh and on a height field, several to each.
class OnGround : public Prisms {
public:
    OnGround(Stepper stepper, bool isMesh) : Prisms(stepper) {
        const Ground ground{13, 0.4, waves};
        const auto mesh = std::make_shared<GridMesh>(ground);
        const auto heights = std::make_shared<HeightGrid>(ground, HeightOptions{});
        keep(mesh);
        keep(heights);
        addParts([&](int part, Vector3 origin) {
            const dGeomID patch =
                add(isMesh ? dCreateTriMesh(space(), mesh->data(), nullptr, nullptr, nullptr)
                           : heights->createGeom(space()));
            dGeomSetPosition(patch, origin.x, origin.y, 0);
            for (int i = 0; i < 5; ++i)
                drop(createPrism(part + i), origin + Vector3{dReal(0.8) * i - 1.6, dReal(0.05) * part, 1.2},
                     i);
        });
    }
};

// Geoms that are given other points and planes between frames, while they lie on others.
class Reshaped : public Prisms {
public:
    explicit Reshaped(Stepper stepper) : Prisms(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i) {
                m_geoms.push_back(createPrism(part + i));
                drop(m_geoms.back(), origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i}, i);
            }
        });
    }

    void control() override {
        for (int i = 0; i < 4; ++i) {
            const std::size_t which = (7 * frameNumber() + 11 * i) % m_geoms.size();
            m_prisms[(frameNumber() + i) % m_prisms.size()]->giveTo(m_geoms[which]);
        }
    }

private:
    std::vector<dGeomID> m_geoms;
};

// Rays through prisms, from inside and outside.
class Rays : public Prisms {
public:
    explicit Rays(Stepper stepper) : Prisms(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            drop(createPrism(part), origin + Vector3{0, 0, 0.5}, part);
            for (int i = 0; i < 8; ++i) {
                const dGeomID ray = add(dCreateRay(space(), 0.2 + 0.3 * i));
                dGeomSetCategoryBits(ray, kDynamicCategory);
                dGeomRaySet(ray, origin.x + 0.2 * i - 0.8, origin.y + 0.01 * part, 0.2, 1 - 0.3 * i, 0.1,
                            0.05 * i);
                dGeomRaySetBackfaceCull(ray, i % 2);
                dGeomRaySetClosestHit(ray, part % 2);
            }
        });
    }
};

// Rays of infinite length that hit no face of a prism: upstream then reports a hit at no distance, and negates the position and the
// normal that the program had in the contact as if it had computed them.
class EndlessRays : public Prisms {
public:
    explicit EndlessRays(Stepper stepper) : Prisms(stepper, SpaceKind::Simple) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 3; ++i) drop(createPrism(part + i), origin + Vector3{dReal(0.05) * i, 0, dReal(0.3) + dReal(0.5) * i}, i);
            const dGeomID ray = add(dCreateRay(space(), dInfinity));
            dGeomSetCategoryBits(ray, kDynamicCategory);
            dGeomRaySet(ray, origin.x - 0.5, origin.y - 0.4, 0.1, 1, 0.8, 0.3 + 0.1 * (part % 5));
        });
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (dGeomGetClass(o1) != dRayClass && dGeomGetClass(o2) != dRayClass) return Prisms::onNearPair(o1, o2);
        m_probe.collide(o1, o2, m_contactLimit, sizeof(dContactGeom));
        m_probe.tell(m_observer);
    }

private:
    ContactProbe m_probe;
};

}  // namespace

void addConvexCrowds(Catalogue &catalogue) {
    constexpr auto shared = Scenario::Callbacks::shared;
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make), callbacks));
    };
    add("convex_crowds/prisms", "heaps of prisms", make<Heaps>(SpaceKind::Hash, false), shared);
    add("convex_crowds/mixed", "prisms among all other shapes, simple space",
        make<Heaps>(SpaceKind::Simple, true));
    add("convex_crowds/on_mesh", "prisms on meshes", make<OnGround>(true), shared);
    add("convex_crowds/on_heights", "prisms on height fields", make<OnGround>(false), shared);
    add("convex_crowds/reshaped", "convex geoms that are given other points", make<Reshaped>());
    add("convex_crowds/rays", "rays through prisms", make<Rays>());
    add("convex_crowds/endless_rays", "rays of infinite length through prisms and past them", make<EndlessRays>());
}

}  // namespace exactness
