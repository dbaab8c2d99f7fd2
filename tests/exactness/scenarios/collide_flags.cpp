#include "additions.h"
#include "contact_probe.h"
#include "ground_grid.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <cmath>

namespace exactness {

namespace {

constexpr int countsAsked[] = {1, 2, 3, 4, 8, 16, 64, 200, 0xffff};
constexpr int unimportant = static_cast<int>(CONTACTS_UNIMPORTANT);

// Stones that fall apart from what is probed, so that there is something to step.
class Probing : public ManyParts {
protected:
    explicit Probing(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 3; ++i)
                addBox(origin + Vector3{0, 0, dReal(0.5) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
        });
    }

    void probe(dGeomID o1, dGeomID o2, int flags, int skip = sizeof(dContactGeom)) {
        m_probe.collide(o1, o2, flags, skip);
        m_probe.tell(m_observer);
    }

    ContactProbe m_probe;
};

bool isConvexWithMesh(dGeomID one, dGeomID other) {
    const int first = dGeomGetClass(one), second = dGeomGetClass(other);
    return (first == dConvexClass && second == dTriMeshClass) ||
           (first == dTriMeshClass && second == dConvexClass);
}

// Two geoms of every two classes of ODE, in no space, that rotate inside one another.
class EveryPair : public Probing {
public:
    void control() override {
        for (std::size_t i = 0; i < m_pairs.size(); ++i) {
            pose(m_pairs[i].one, static_cast<int>(i));
            pose(m_pairs[i].other, static_cast<int>(i) + 31);
            ask(m_pairs[i].one, m_pairs[i].other);
            ask(m_pairs[i].other, m_pairs[i].one);
        }
    }

protected:
    explicit EveryPair(Stepper stepper) : Probing(stepper) {
        const Ground ground{9, 0.15, [](int x, int y) { return waves(x, y) - 0.5; }};
        m_heights = std::make_shared<HeightGrid>(ground, HeightOptions{});
        m_mesh = std::make_shared<GridMesh>(ground);
        keep(m_heights);
        keep(m_mesh);
        for (int one = 0; one < classCount; ++one) {
            for (int other = one; other < classCount; ++other)
                m_pairs.push_back({add(create(one)), add(create(other))});
        }
    }

    virtual void ask(dGeomID one, dGeomID other) = 0;

private:
    struct Pair {
        dGeomID one, other;
    };

    static constexpr int shapeCount = sizeof(allShapes) / sizeof(allShapes[0]), classCount = shapeCount + 5;

    dGeomID create(int number) const {
        if (number < shapeCount) return createShape(nullptr, allShapes[number]);
        switch (number - shapeCount) {
            case 0:
                return dCreatePlane(nullptr, 0, 0, 1, 0);
            case 1:
                return dCreateRay(nullptr, 1.2);
            case 2:
                return m_heights->createGeom(nullptr);
            case 3:
                return dCreateTriMesh(nullptr, m_mesh->data(), nullptr, nullptr, nullptr);
            default:
                return createTransform();
        }
    }

    static dGeomID createTransform() {
        const dGeomID transform = dCreateGeomTransform(nullptr);
        dGeomTransformSetCleanup(transform, 1);
        dGeomTransformSetInfo(transform, 1);
        const dGeomID child = createShape(nullptr, Shape::Capsule);
        dGeomSetPosition(child, 0.1, 0, 0.05);
        dGeomTransformSetGeom(transform, child);
        return transform;
    }

    void pose(dGeomID geom, int number) const {
        const dReal t = 0.37 * frameNumber() + 0.61 * number;
        if (dGeomGetClass(geom) == dPlaneClass) {
            dGeomPlaneSetParams(geom, 0.3 * std::sin(t), 0.2, 1, 0.2 * std::cos(t));
            return;
        }
        dGeomSetPosition(geom, 0.2 * std::sin(t), 0.2 * std::cos(1.3 * t), 0.25 * std::sin(0.7 * t));
        dQuaternion turn;
        dQFromAxisAndAngle(turn, std::cos(t), 0.5, std::sin(2 * t), number + 0.8 * t);
        dGeomSetQuaternion(geom, turn);
    }

    std::shared_ptr<HeightGrid> m_heights;
    std::shared_ptr<GridMesh> m_mesh;
    std::vector<Pair> m_pairs;
};

class Counts : public EveryPair {
public:
    Counts(Stepper stepper, int modifier) : EveryPair(stepper), m_modifier(modifier) {}

protected:
    void ask(dGeomID one, dGeomID other) override {
        // Upstream returns an unset variable of its stack then.
        if (m_modifier == unimportant && isConvexWithMesh(one, other)) return;
        for (int count : countsAsked) probe(one, other, count | m_modifier);
    }

private:
    int m_modifier;
};

// Contacts far apart in memory: within dContact, and within something larger.
class Strides : public EveryPair {
public:
    explicit Strides(Stepper stepper) : EveryPair(stepper) {}

protected:
    void ask(dGeomID one, dGeomID other) override {
        for (int skip :
             {static_cast<int>(sizeof(dContactGeom)) + 8, static_cast<int>(sizeof(dContact)), 1000}) {
            probe(one, other, 16, skip);
            if (!isConvexWithMesh(one, other)) probe(one, other, 2 | unimportant, skip);
        }
    }
};

// dCollide with spaces of every kind, against geoms and against one another.
class WithSpaces : public Probing {
public:
    explicit WithSpaces(Stepper stepper) : Probing(stepper) {
        for (SpaceKind kind : allSpaceKinds) {
            const dSpaceID made = addSpace(createSpace(kind, nullptr));
            for (int i = 0; i < 12; ++i) addStone(made, i);
            m_spaces.push_back(reinterpret_cast<dGeomID>(made));
        }
        for (Shape shape : allShapes) m_strays.push_back(add(createShape(nullptr, shape)));
        m_strays.push_back(add(dCreateRay(nullptr, 3)));
    }

    void control() override {
        for (std::size_t i = 0; i < m_stones.size(); ++i)
            if (i % 3 == frameNumber() % 3u) place(m_stones[i], static_cast<int>(i), 0.01 * frameNumber());
        for (dGeomID stray : m_strays) dGeomSetPosition(stray, 0.1 * frameNumber(), 0.1, 0.2);
        for (int count : {1, 3, 8, 200}) {
            for (dGeomID one : m_spaces) {
                for (dGeomID other : m_spaces) probe(one, other, count);
                for (dGeomID stray : m_strays) {
                    probe(one, stray, count);
                    probe(stray, one, count | unimportant);
                }
            }
        }
    }

private:
    void addStone(dSpaceID where, int number) {
        const dGeomID stone = add(createShape(where, allShapes[number % 6]));
        place(stone, number, 0);
        m_stones.push_back(stone);
    }

    static void place(dGeomID stone, int number, dReal shift) {
        dGeomSetPosition(stone, 0.4 * (number % 4) + shift, 0.35 * (number / 4 % 3),
                         0.15 * (number % 5) - shift);
    }

    std::vector<dGeomID> m_spaces, m_stones, m_strays;
};

}  // namespace

void addCollideFlags(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, int steps, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, steps, std::move(make)));
    };
    add("collide_flags/counts", "dCollide for 1 to 65535 contacts, geoms of every two classes, both ways", 8,
        make<Counts>(0));
    add("collide_flags/unimportant", "the same for contacts of no importance", 8, make<Counts>(unimportant));
    add("collide_flags/strides", "contacts far apart in memory, and nothing written between them", 12,
        make<Strides>());
    add("collide_flags/spaces", "dCollide with spaces of every kind", 12, make<WithSpaces>());
}

}  // namespace exactness
