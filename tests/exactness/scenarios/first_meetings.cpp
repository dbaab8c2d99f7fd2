// The first pairs of two classes of geoms, when the table of colliders decides who collides them.
//
// Covers dxColliderTable.cpp.
#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

namespace exactness {

namespace {

// Geoms of the user's classes meet geoms of every other kind, one pair of classes after the other: geom
// transforms, spaces, overridden colliders, classes that were created before and after, their own. What is
// asked of whom is noted.
class FirstMeetings : public ManyParts {
public:
    FirstMeetings(Stepper stepper, bool isOverriddenFirst) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i});
        });
        if (isOverriddenFirst) setOverrides();
        createClass(&choose<0>);
        createClass(&choose<1>);
        if (!isOverriddenFirst) setOverrides();
        createClass(&choose<2>);
        createClass(&choose<3>);
        for (int user = 0; user < 4; ++user)
            for (int copy = 0; copy < 2; ++copy) m_geoms.push_back(dCreateGeom(m_classes[user]));
        m_geoms.push_back(dCreateSphere(nullptr, 0.5));
        m_geoms.push_back(dCreateBox(nullptr, 1, 1, 1));
        m_geoms.push_back(dCreatePlane(nullptr, 0, 0, 1, 0));
        m_geoms.push_back(createTransform(dCreateSphere(nullptr, 0.5)));
        m_geoms.push_back(createTransform(dCreateGeom(m_classes[1])));
        for (SpaceKind kind : allSpaceKinds) {
            const dSpaceID made = createSpace(kind, nullptr);
            dCreateSphere(made, 0.5);
            dSpaceAdd(made, dCreateGeom(m_classes[2]));
            m_geoms.push_back(reinterpret_cast<dGeomID>(made));
        }
    }
    ~FirstMeetings() override {
        for (dGeomID geom : m_geoms) dGeomDestroy(geom);
    }

    void control() override {
        const int count = static_cast<int>(m_geoms.size()), first = frameNumber() % count;
        for (int other = 0; other < count; ++other)
            meet((first + 3 * other) % count, (first * 7 + other) % count);
        if (frameNumber() == count) dSetColliderOverride(m_classes[3], dBoxClass, nullptr);
        if (frameNumber() == count + 3) dSetColliderOverride(m_classes[3], dBoxClass, &collideAnything);
    }

private:
    void createClass(dGetColliderFnFn *choose) {
        const dGeomClass description = {sizeof(int), choose, &bound, nullptr, nullptr};
        m_classes.push_back(dCreateGeomClass(&description));
    }

    static void setOverrides() {
        dSetColliderOverride(dFirstUserClass + 1, dSphereClass, nullptr);
        dSetColliderOverride(dFirstUserClass + 1, dFirstUserClass + 2, nullptr);
        dSetColliderOverride(dFirstUserClass, dBoxClass, &collideAnything);
        dSetColliderOverride(dFirstUserClass + 3, dFirstUserClass + 3, &collideAnything);
        dSetColliderOverride(dFirstUserClass, dGeomTransformClass, nullptr);
    }

    static dGeomID createTransform(dGeomID child) {
        const dGeomID transform = dCreateGeomTransform(nullptr);
        dGeomTransformSetCleanup(transform, 1);
        dGeomTransformSetGeom(transform, child);
        return transform;
    }

    // The first collides with all, the second with classes of odd numbers, the third with none, the fourth
    // with all but itself.
    template <int user>
    static dColliderFn *choose(int other) {
        static_cast<FirstMeetings &>(living()).note("asked", 100 * user + other);
        const bool collides =
            user == 0 || (user == 1 && other % 2 == 1) || (user == 3 && other != dFirstUserClass + 3);
        return collides ? &collideAnything : nullptr;
    }

    static int collideAnything(dGeomID one, dGeomID other, int, dContactGeom *contact, int) {
        auto &scene = static_cast<FirstMeetings &>(living());
        scene.note("collided", 100 * dGeomGetClass(one) + dGeomGetClass(other));
        contact->pos[0] = contact->pos[1] = contact->pos[2] = dGeomGetClass(one);
        contact->normal[0] = 1;
        contact->normal[1] = contact->normal[2] = 0;
        contact->depth = dGeomGetClass(other);
        contact->g1 = one;
        contact->g2 = other;
        contact->side1 = 1;
        contact->side2 = 2;
        return 1;
    }

    static void bound(dGeomID, dReal box[6]) {
        for (int i = 0; i < 6; ++i) box[i] = i % 2 == 0 ? -1 : 1;
    }

    void meet(int first, int second) {
        dContactGeom contacts[4] = {};
        const int count = dCollide(m_geoms[first], m_geoms[second], 4, contacts, sizeof contacts[0]);
        note("first geom", first);
        note("second geom", second);
        note("contacts", count);
        for (int i = 0; i < count; ++i) {
            note("normal", contacts[i].normal[0]);
            note("depth", contacts[i].depth);
            note("sides", 10 * contacts[i].side1 + contacts[i].side2);
            note("turned", contacts[i].g1 == m_geoms[second]);
        }
    }

    std::vector<int> m_classes;
    std::vector<dGeomID> m_geoms;
};

}  // namespace

void addFirstMeetings(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make)));
    };
    add("first_meetings/all", "user classes collide with every other kind of geom",
        make<FirstMeetings>(false));
    add("first_meetings/overridden_before", "the same with colliders set before the classes are created",
        make<FirstMeetings>(true));
}

}  // namespace exactness
