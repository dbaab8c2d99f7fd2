// Geom classes and colliders of the user.
//
// Covers api/collision.cpp, dxColliderTable.cpp.
#include "additions.h"
#include "order_sum.h"
#include "scenario_scene.h"
#include "shapes.h"

namespace exactness {

namespace {

// Geoms of the user's classes: each is a shell around a sphere of ODE's own that is in no space, and collides
// by asking dCollide for that sphere. All that ODE asks of a class is summed up in order.
struct Shell {
    dGeomID core;
};

class Shells : public ManyParts {
public:
    ~Shells() override {
        for (dGeomID core : m_cores) dGeomDestroy(core);
    }

    void control() override {
        note("questions", static_cast<double>(m_asked.count()));
        note("sum of the questions", m_asked.value());
    }

protected:
    Shells(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) { addGround(); }

    // For ODE's calls, which get no scene.
    static Shells &self() { return static_cast<Shells &>(living()); }
    static void asked(int question) { self().m_asked.add(question); }
    static int frame() { return self().frameNumber(); }

    static int createClass(dGetColliderFnFn *choose, dGetAABBFn *bound, dAABBTestFn *test) {
        const dGeomClass description = {sizeof(Shell), choose, bound, test, &forget};
        return dCreateGeomClass(&description);
    }

    dGeomID createShell(int ofClass, dReal radius) {
        const dGeomID shell = dCreateGeom(ofClass);
        m_cores.push_back(dCreateSphere(nullptr, radius));
        static_cast<Shell *>(dGeomGetClassData(shell))->core = m_cores.back();
        dSpaceAdd(space(), shell);
        return shell;
    }

    static dGeomID coreOf(dGeomID shell) {
        const dGeomID core = static_cast<Shell *>(dGeomGetClassData(shell))->core;
        const dReal *place = dGeomGetPosition(shell);
        dGeomSetPosition(core, place[0], place[1], place[2]);
        return core;
    }

    static bool isShell(dGeomID geom) { return dGeomGetClass(geom) >= dFirstUserClass; }

    static int collideShell(dGeomID shell, dGeomID other, int flags, dContactGeom *contacts, int skip) {
        asked(1000 * dGeomGetClass(shell) + dGeomGetClass(other));
        const dGeomID second = isShell(other) ? coreOf(other) : other;
        const int count = dCollide(coreOf(shell), second, flags, contacts, skip);
        for (int i = 0; i < count; ++i) {
            auto *contact = reinterpret_cast<dContactGeom *>(reinterpret_cast<char *>(contacts) + i * skip);
            contact->g1 = shell;
            contact->g2 = other;
        }
        return count;
    }

    static void boundShell(dGeomID shell, dReal box[6]) {
        asked(-dGeomGetClass(shell));
        dGeomGetAABB(coreOf(shell), box);
    }

    OrderSum m_asked;

private:
    static void forget(dGeomID shell) { static_cast<Shell *>(dGeomGetClassData(shell))->core = nullptr; }

    std::vector<dGeomID> m_cores;
};

// All four classes that a program may have: one collides with everything, one only with planes, one leaves it
// to the others, one with no one. Two test boxes themselves.
class Classes : public Shells {
public:
    Classes(Stepper stepper, SpaceKind kind) : Shells(stepper, kind) {
        const int classes[] = {
            createClass(&withAll, &boundShell, nullptr), createClass(&withPlanes, &boundShell, &testBox),
            createClass(&withNone, &boundShell, nullptr), createClass(&withNone, &boundWide, &testBox)};
        addParts([this, &classes](int part, Vector3 origin) {
            for (int i = 0; i < 8; ++i) {
                const Vector3 place{dReal(0.03) * part, dReal(0.05) * (i % 3), dReal(0.3) + dReal(0.45) * i};
                const dGeomID geom = i % 3 == 2 ? createShape(space(), allShapes[part % 6])
                                                : createShell(classes[(part + i) % 4], 0.25);
                carry(geom, origin + place);
            }
        });
    }

private:
    static dColliderFn *withAll(int) { return &collideShell; }
    static dColliderFn *withPlanes(int other) { return other == dPlaneClass ? &collideShell : nullptr; }
    static dColliderFn *withNone(int) { return nullptr; }

    static void boundWide(dGeomID shell, dReal box[6]) {
        boundShell(shell, box);
        box[1] += 0.5;
    }

    static int testBox(dGeomID shell, dGeomID other, dReal box[6]) {
        asked(dGeomGetClass(other));
        return box[4] < dGeomGetPosition(shell)[2] + 0.2 ? 1 : 0;
    }
};

// Infinite bounding boxes, and boxes that change although the geom does not move.
class OddBounds : public Shells {
public:
    OddBounds(Stepper stepper, SpaceKind kind) : Shells(stepper, kind) {
        const int endless = createClass(&withAll, &boundEndless, nullptr);
        const int breathing = createClass(&withAll, &boundBreathing, nullptr);
        for (int i = 0; i < 3; ++i) {
            const dGeomID wall = add(createShell(endless, 0.5));
            dGeomSetPosition(wall, 20 * i, 0.3, 0.2);
        }
        addParts([this, breathing](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                const dGeomID geom =
                    i % 2 == 0 ? createShell(breathing, 0.25) : createShape(space(), Shape::Box);
                carry(geom, origin + Vector3{dReal(0.02) * part, 0, dReal(0.3) + dReal(0.5) * i});
            }
        });
    }

private:
    static dColliderFn *withAll(int) { return &collideShell; }

    static void boundEndless(dGeomID, dReal box[6]) {
        for (int i = 0; i < 6; ++i) box[i] = i % 2 == 0 ? -dInfinity : dInfinity;
    }

    static void boundBreathing(dGeomID shell, dReal box[6]) {
        boundShell(shell, box);
        box[0] -= 0.1 * (frame() % 5);
    }
};

// Colliders of ODE's own classes are put aside by the user's, by others and by none, between frames.
class Overrides : public Shells {
public:
    Overrides(Stepper stepper, SpaceKind kind) : Shells(stepper, kind) {
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 6; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.04) * i, dReal(0.02) * part, dReal(0.3) + dReal(0.45) * i});
        });
    }

    void control() override {
        Shells::control();
        const bool isOdd = frameNumber() / 5 % 2 == 1;
        if (frameNumber() % 5 != 0) return;
        dSetColliderOverride(dSphereClass, dBoxClass, isOdd ? &seldom : &always);
        dSetColliderOverride(dCapsuleClass, dPlaneClass, isOdd ? &always : &seldom);
        dSetColliderOverride(dCylinderClass, dCylinderClass, isOdd ? nullptr : &always);
    }

private:
    static int atMiddle(dGeomID one, dGeomID other, dContactGeom *contact, dReal depth) {
        const dReal *place = dGeomGetPosition(one);
        for (int i = 0; i < 3; ++i) {
            contact->pos[i] = place[i];
            contact->normal[i] = i == 2 ? 1 : 0;
        }
        contact->depth = depth;
        contact->g1 = one;
        contact->g2 = other;
        contact->side1 = contact->side2 = -1;
        return 1;
    }

    static int seldom(dGeomID one, dGeomID other, int, dContactGeom *contact, int) {
        asked(dGeomGetClass(other));
        return dGeomGetPosition(one)[2] < 0.15 ? atMiddle(one, other, contact, 0.02) : 0;
    }

    static int always(dGeomID one, dGeomID other, int flags, dContactGeom *contact, int) {
        asked(flags);
        const bool isLow = dGeomGetPosition(one)[2] < 0.4;
        return isLow ? atMiddle(one, other, contact, 0.01) : 0;
    }
};

}  // namespace

void addUserColliders(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make)));
    };
    add("user_colliders/classes", "four classes that collide with all, some, none, and test boxes",
        make<Classes>(SpaceKind::Hash));
    add("user_colliders/classes_in_simple", "the same in a simple space", make<Classes>(SpaceKind::Simple));
    add("user_colliders/classes_in_sweep_and_prune", "the same in a sweep-and-prune space",
        make<Classes>(SpaceKind::SweepAndPrune));
    add("user_colliders/odd_bounds", "infinite bounding boxes, and some that change at rest",
        make<OddBounds>(SpaceKind::Hash));
    add("user_colliders/overrides", "colliders of ODE's classes put aside between frames",
        make<Overrides>(SpaceKind::Simple));
}

}  // namespace exactness
