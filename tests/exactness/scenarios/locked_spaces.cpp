#include "additions.h"
#include "scenario_scene.h"

#include <csetjmp>
#include <cstdarg>
#include <cstdio>

namespace exactness {

namespace {

std::jmp_buf beforeTheCall;

// Calls that are an error, and whose error the debug handler leaves by a jump to where the call was made.
// Only such calls are made as upstream refuses before it has changed anything.
class Refusals : public ManyParts {
public:
    ~Refusals() override {
        dSetDebugHandler(nullptr);
        dSetErrorHandler(nullptr);
    }

protected:
    Refusals(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        dSetDebugHandler(&handle);
        dSetErrorHandler(&handle);
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                addBox(origin + Vector3{dReal(0.02) * i, 0, dReal(0.3) + dReal(0.5) * i}, {0.5, 0.5, 0.5}, 1);
        });
    }

    template <class Call>
    void attempt(const Call &call) {
        if (setjmp(beforeTheCall) != 0) return;
        call();
        note("not refused");
    }

private:
    static void handle(int number, const char *format, va_list arguments) {
        char text[300];
        std::vsnprintf(text, sizeof(text), format, arguments);
        static_cast<Refusals &>(living()).note(text, number);
        std::longjmp(beforeTheCall, 1);
    }
};

// What is forbidden while a space is locked, in its callbacks.
class InCallbacks : public Refusals {
public:
    InCallbacks(Stepper stepper, SpaceKind kind)
        : Refusals(stepper, kind), m_stray(add(dCreateSphere(nullptr, 1))) {}

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const dGeomID stone = dGeomGetBody(o1) != nullptr ? o1 : o2;
        const int number = m_calls++ % callCount;
        attempt([=] { makeCall(number, stone); });
        Refusals::onNearPair(o1, o2);
    }

private:
    static constexpr int callCount = 12;

    void makeCall(int number, dGeomID stone) {
        const dMatrix3 turn = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        const dQuaternion noTurn = {1, 0, 0, 0};
        switch (number) {
            case 0:
                return dGeomSetPosition(stone, 0, 0, 1);
            case 1:
                return dGeomSetRotation(stone, turn);
            case 2:
                return dGeomSetQuaternion(stone, noTurn);
            case 3:
                return dGeomSetBody(stone, nullptr);
            case 4:
                return dGeomSetCategoryBits(stone, 4);
            case 5:
                return dGeomSetCollideBits(stone, 4);
            case 6:
                return dSpaceAdd(space(), m_stray);
            case 7:
                return dSpaceRemove(space(), stone);
            case 8:
                return dGeomSetOffsetPosition(stone, 0, 0, 0.1);
            case 9:
                return dGeomSetOffsetRotation(stone, turn);
            case 10:
                return dGeomSetOffsetQuaternion(stone, noTurn);
            default:
                return dGeomSetOffsetWorldPosition(stone, 0, 0, 1);
        }
    }

    dGeomID m_stray;
    int m_calls = 0;
};

// Wrong arguments to collision functions, between frames.
class WrongCalls : public Refusals {
public:
    WrongCalls(Stepper stepper, SpaceKind kind)
        : Refusals(stepper, kind),
          m_simple(addSpace(dSimpleSpaceCreate(nullptr))),
          m_plane(m_inventory.geoms[0]),
          m_box(m_inventory.geoms[1]) {}

    void control() override {
        tryGeoms();
        trySpaces();
        tryShapes();
    }

private:
    void tryGeoms() {
        dContactGeom contact;
        const dBodyID body = m_inventory.bodies[0];
        attempt([=] { dGeomSetPosition(m_plane, 0, 0, 0); });
        attempt([=] { dGeomSetBody(m_plane, body); });
        attempt([=] { dGeomGetRotation(m_plane); });
        attempt([=] { dGeomSetOffsetPosition(m_plane, 0, 0, 0); });
        attempt([&] { dCollide(m_box, m_plane, 0, &contact, sizeof(contact)); });
        attempt([&] { dCollide(m_box, nullptr, 1, &contact, sizeof(contact)); });
        attempt([&] { dCollide(m_box, m_plane, 1, nullptr, sizeof(contact)); });
    }

    void trySpaces() {
        const dSpaceID simple = m_simple;
        attempt([=] { dHashSpaceSetLevels(space(), 3, 2); });
        attempt([=] { dHashSpaceSetLevels(simple, 1, 2); });
        attempt([=] { dSpaceAdd(simple, m_box); });
        attempt([=] { dSpaceRemove(simple, m_box); });
        attempt([=] { dSpaceGetGeom(simple, 0); });
        attempt([=] { dSpaceGetGeom(space(), dSpaceGetNumGeoms(space())); });
        attempt([=] { dSpaceCollide(reinterpret_cast<dSpaceID>(m_box), nullptr, &ignore); });
        attempt([=] { dSpaceSetCleanup(reinterpret_cast<dSpaceID>(m_box), 1); });
        attempt([=] { dSpaceDestroy(reinterpret_cast<dSpaceID>(m_box)); });
        attempt([=] { dSpaceCollide2(m_box, nullptr, nullptr, &ignore); });
    }

    void tryShapes() {
        attempt([=] { dGeomSphereSetRadius(m_box, 1); });
        attempt([=] { dGeomBoxSetLengths(m_box, -1, 1, 1); });
        attempt([=] { dGeomPlaneSetParams(m_box, 0, 0, 1, 0); });
        attempt([=] { dGeomCapsuleSetParams(m_box, 1, 1); });
        attempt([=] { dGeomCylinderSetParams(m_box, 1, 1); });
        attempt([=] { dGeomRaySetLength(m_box, 1); });
        attempt([=] { dGeomTriMeshSetCallback(m_box, nullptr); });
        attempt([=] { dGeomHeightfieldGetHeightfieldData(m_box); });
        attempt([=] { dGeomGetClassData(m_box); });
        attempt([=] { dCreateGeom(dSphereClass); });
        attempt([=] { dCreateGeomClass(nullptr); });
    }

    static void ignore(void *, dGeomID, dGeomID) {}

    dSpaceID m_simple;
    dGeomID m_plane, m_box;
};

}  // namespace

void addLockedSpaces(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 20, std::move(make)));
    };
    add("locked_spaces/simple", "callbacks try what a locked simple space forbids",
        make<InCallbacks>(SpaceKind::Simple));
    add("locked_spaces/hash", "callbacks try what a locked hash space forbids",
        make<InCallbacks>(SpaceKind::Hash));
    add("locked_spaces/sweep_and_prune", "callbacks try what a locked sweep-and-prune space forbids",
        make<InCallbacks>(SpaceKind::SweepAndPrune));
    add("locked_spaces/quad_tree", "callbacks try what a locked quad-tree space forbids",
        make<InCallbacks>(SpaceKind::QuadTree));
    add("locked_spaces/wrong_calls", "wrong arguments to collision functions",
        make<WrongCalls>(SpaceKind::Hash));
}

}  // namespace exactness
