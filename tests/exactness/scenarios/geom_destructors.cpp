#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <algorithm>
#include <csetjmp>
#include <cstdarg>
#include <cstdio>

namespace exactness {

namespace {

std::jmp_buf beforeTheCall;

// Stacks, and beside them a space that is made and destroyed again and again.
class PassingSpaces : public ManyParts {
protected:
    PassingSpaces(Stepper stepper, SpaceKind kind) : ManyParts(stepper), m_kind(kind) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i});
        });
    }

    static void count(void *scene, dGeomID, dGeomID) { ++static_cast<PassingSpaces *>(scene)->m_pairs; }

    void notePairsOf(dSpaceID which) {
        m_pairs = 0;
        dSpaceCollide(which, this, &count);
        note("pairs", m_pairs);
    }

    SpaceKind m_kind;
    int m_pairs = 0;
};

// Geoms of a class whose destructor destroys the geom's body, or changes others of the same space, while the
// space is being destroyed. It moves them only where upstream does not put them before its place in the list,
// to be forgotten there.
class Destructors : public PassingSpaces {
public:
    Destructors(Stepper stepper, SpaceKind kind) : PassingSpaces(stepper, kind) {
        const dGeomClass description = {sizeof(int), &noCollider, &bound, nullptr, &destroyed};
        m_class = dCreateGeomClass(&description);
    }

    void control() override {
        const dSpaceID outer = createSpace(m_kind, nullptr), inner = createSpace(m_kind, outer);
        for (int i = 0; i < 40; ++i) makeGeom(i % 5 == 4 ? inner : outer, i);
        notePairsOf(outer);
        for (int i = 0; i < 6; ++i)
            dGeomSetPosition(m_living[3 * i], i, 0.2, 0.3);  // some are dirty, some are clean
        if (frameNumber() % 2 == 0) notePairsOf(inner);
        dSpaceDestroy(outer);
        note("still there", static_cast<double>(m_living.size()));
    }

private:
    static Destructors &self() { return static_cast<Destructors &>(living()); }
    static int numberOf(dGeomID geom) { return *static_cast<int *>(dGeomGetClassData(geom)); }
    static dColliderFn *noCollider(int) { return nullptr; }

    static void bound(dGeomID geom, dReal box[6]) {
        const dReal *place = dGeomGetPosition(geom);
        for (int i = 0; i < 6; ++i) box[i] = place[i / 2] + (i % 2 == 0 ? -0.6 : 0.6);
    }

    void makeGeom(dSpaceID where, int number) {
        const dGeomID geom = dCreateGeom(m_class);
        *static_cast<int *>(dGeomGetClassData(geom)) = number;
        dSpaceAdd(where, geom);
        if (number % 3 != 0) dGeomSetBody(geom, dBodyCreate(world()));
        dGeomSetPosition(geom, number % 9, 0.1 * number, 100);
        m_living.push_back(geom);
    }

    static void destroyed(dGeomID geom) {
        Destructors &scene = self();
        const int number = numberOf(geom);
        scene.note("destroyed", number);
        std::vector<dGeomID> &living = scene.m_living;
        living.erase(std::remove(living.begin(), living.end(), geom), living.end());
        if (const dBodyID body = dGeomGetBody(geom)) dBodyDestroy(body);
        if (!living.empty())
            scene.disturb(living[(7 * number + scene.frameNumber()) % living.size()], number);
    }

    void disturb(dGeomID other, int number) {
        switch ((number + frameNumber()) % 6) {
            case 0:
                return dGeomSetCategoryBits(other, 6);
            case 1:
                return dGeomSetCollideBits(other, 5);
            case 2:
                if (m_kind == SpaceKind::SweepAndPrune) dGeomSetPosition(other, 0.5 * number, 0, 90);
                return;
            case 3:
                return dGeomDisable(other);
            case 4:
                if (dGeomGetBody(other) == nullptr) return;
                dBodyDestroy(dGeomGetBody(other));
                return note("a body destroyed for another geom", numberOf(other));
            default:
                return note("left alone", numberOf(other));
        }
    }

    int m_class;
    std::vector<dGeomID> m_living;
};

// Geoms that outlive their space, and come into others.
class Survivors : public PassingSpaces {
public:
    Survivors(Stepper stepper, SpaceKind kind) : PassingSpaces(stepper, kind) { dSetDebugHandler(&handle); }
    ~Survivors() override { dSetDebugHandler(nullptr); }

    void control() override {
        for (const SpaceKind next : allSpaceKinds) {
            const dSpaceID first = createSpace(m_kind, nullptr);
            dSpaceSetCleanup(first, 0);
            dGeomID geoms[3];
            for (dGeomID &geom : geoms) geom = dCreateSphere(first, 1);
            if (frameNumber() % 2 == 0) notePairsOf(first);
            if (frameNumber() % 3 == 0) dSpaceRemove(first, geoms[1]);
            dSpaceDestroy(first);
            const dSpaceID second = createSpace(next, nullptr);
            for (dGeomID geom : geoms) attempt([=] { dSpaceAdd(second, geom); });
            notePairsOf(second);
            for (dGeomID geom : geoms) dGeomDestroy(geom);
            dSpaceDestroy(second);
        }
    }

private:
    template <class Call>
    void attempt(const Call &call) {
        if (setjmp(beforeTheCall) != 0) return;
        call();
        note("not refused");
    }

    static void handle(int number, const char *format, va_list arguments) {
        char text[300];
        std::vsnprintf(text, sizeof(text), format, arguments);
        static_cast<Survivors &>(living()).note(text, number);
        std::longjmp(beforeTheCall, 1);
    }
};

}  // namespace

void addGeomDestructors(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 24, std::move(make)));
    };
    add("geom_destructors/in_simple",
        "a user's destructor destroys bodies and changes geoms while a space goes",
        make<Destructors>(SpaceKind::Simple));
    add("geom_destructors/in_hash", "the same in a hash space", make<Destructors>(SpaceKind::Hash));
    add("geom_destructors/in_sweep_and_prune", "the same in a sweep-and-prune space",
        make<Destructors>(SpaceKind::SweepAndPrune));
    add("geom_destructors/in_quad_tree", "the same in a quad-tree space",
        make<Destructors>(SpaceKind::QuadTree));
    add("geom_destructors/outlive_simple", "geoms outlive a simple space and are added to others",
        make<Survivors>(SpaceKind::Simple));
    add("geom_destructors/outlive_hash", "geoms outlive a hash space and are added to others",
        make<Survivors>(SpaceKind::Hash));
    add("geom_destructors/outlive_sweep_and_prune",
        "geoms outlive a sweep-and-prune space and are added to others",
        make<Survivors>(SpaceKind::SweepAndPrune));
    add("geom_destructors/outlive_quad_tree",
        "geoms outlive a quad-tree space, which other such spaces refuse",
        make<Survivors>(SpaceKind::QuadTree));
}

}  // namespace exactness
