#include "additions.h"
#include "left_call.h"
#include "order_sum.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace exactness {

namespace {

enum class Doing { Cleans, Collides, Asks, Grows, Throws, Jumps };

// A class of the user's whose bounding-box function has its own space cleaned, collides or asks it, makes
// geoms of it larger (which is refused when it is half done), or leaves.
class BoxFunctions : public ManyParts {
public:
    BoxFunctions(Stepper stepper, SpaceKind kind, Doing doing, int geoms)
        : ManyParts(stepper), m_kind(kind), m_doing(doing), m_space(createSpace(kind, nullptr)) {
        dSetDebugHandler(&handle);
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i});
        });
        const dGeomClass description = {sizeof(int), &noCollider, &bound, nullptr, nullptr};
        m_class = dCreateGeomClass(&description);
        for (int i = 0; i < geoms; ++i) addGeom(i);
        m_ray = dCreateRay(nullptr, 20);
        dGeomRaySet(m_ray, -1, 2, 0.1, 1, 0.1, 0);
    }
    ~BoxFunctions() override { dSetDebugHandler(nullptr); }

    void control() override {
        const int frame = frameNumber();
        m_isDisturbing = frame % 3 == 0 && (m_geoms.size() == kFew || frame >= 6);  // among many not before a call is shared
        const int moved = frame % 7 * static_cast<int>(m_geoms.size()) / kFew;
        for (int i = 0; i < moved; ++i)
            attempt([=] { dGeomSetPosition(m_geoms[(5 * i + frame) % m_geoms.size()], i % 20, 0.3 * (i / 20 + i % 20), 0); });
        m_pairs = OrderSum();
        attempt([this] { dSpaceCollide(m_space, this, &meet); });
        if (m_kind != SpaceKind::SweepAndPrune)
            attempt([this] { dSpaceCollide2(m_ray, reinterpret_cast<dGeomID>(m_space), this, &meet); });
        note("pairs", static_cast<double>(m_pairs.count()));
        note("sum of the pairs", m_pairs.value());
    }

    static constexpr int kFew = 25, kMany = 800;  // geoms; calls of kMany are shared

private:
    static BoxFunctions &self() { return static_cast<BoxFunctions &>(living()); }
    static dColliderFn *noCollider(int) { return nullptr; }

    void addGeom(int number) {
        const bool isUsers = number % 4 == 2;
        const dGeomID geom = isUsers ? dCreateGeom(m_class) : dCreateSphere(nullptr, 0.5);
        dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(number)));
        dSpaceAdd(m_space, geom);
        dGeomSetPosition(geom, number % 5, number / 5, 0);
        m_geoms.push_back(geom);
    }

    static void bound(dGeomID geom, dReal box[6]) {
        const dReal *place = dGeomGetPosition(geom);
        for (int i = 0; i < 6; ++i) box[i] = place[i / 2] + (i % 2 == 0 ? -0.6 : 0.6);
        BoxFunctions &scene = self();
        if (!scene.m_isDisturbing) return;
        scene.m_isDisturbing = false;
        scene.note("disturbed", static_cast<double>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))));
        scene.disturb();
        scene.m_isDisturbing = scene.frameNumber() % 2 == 0;
    }

    void disturb() {
        switch (m_doing) {
            case Doing::Cleans:
                return dSpaceClean(m_space);
            case Doing::Collides:
                return dSpaceCollide(m_space, this, &meet);
            case Doing::Asks:
                return dSpaceCollide2(m_ray, reinterpret_cast<dGeomID>(m_space), this, &meet);
            case Doing::Grows:
                return growOthers();
            case Doing::Throws:
                throw 1;
            case Doing::Jumps:
                std::longjmp(beforeTheCall, 1);
        }
    }

    // The first clean ones, which upstream's lists clean now because they are behind those that moved; in one
    // frame also one that becomes a stray.
    void growOthers() {
        const int frame = frameNumber(), moved = frame % 7;
        if (moved == 0) return;
        growTooLate(moved);
        if (frame % 4 == 0) growTooLate(moved + 1);
        if (frame == 36) growTooLate(moved + 4);
    }

    // Requires the geom's place in the space.
    void growTooLate(int place) {
        const dGeomID geom = m_kind == SpaceKind::QuadTree ? m_geoms[place] : dSpaceGetGeom(m_space, place);
        if (dGeomGetClass(geom) != dSphereClass) return;
        std::jmp_buf outer;
        std::memcpy(&outer, &beforeTheCall, sizeof outer);
        if (setjmp(beforeTheCall) == 0) dGeomSphereSetRadius(geom, 0.5 + 0.01 * frameNumber());
        std::memcpy(&beforeTheCall, &outer, sizeof outer);
    }

    template <class Call>
    void attempt(const Call &call) {
        if (throwsAnInt(call)) note("thrown");
    }

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        const auto name = [](dGeomID geom) { return reinterpret_cast<std::intptr_t>(dGeomGetData(geom)); };
        static_cast<BoxFunctions *>(data)->m_pairs.add(1000 * name(o1) + name(o2));
    }

    static void handle(int number, const char *format, va_list arguments) {
        char text[300];
        std::vsnprintf(text, sizeof(text), format, arguments);
        for (char *at = text; *at != 0; ++at)
            if (*at == '[') *at = 0;  // file and line
        self().note(text, number);
        std::longjmp(beforeTheCall, 1);
    }

    SpaceKind m_kind;
    Doing m_doing;
    dSpaceID m_space;
    int m_class;
    bool m_isDisturbing = false;
    std::vector<dGeomID> m_geoms;
    dGeomID m_ray;
    OrderSum m_pairs;
};

}  // namespace

void addBoxFunctions(Catalogue &catalogue) {
    const struct {
        Doing doing;
        const char *name, *meaning;
        int frames = 12, geoms = BoxFunctions::kFew;
    } doings[] = {{Doing::Cleans, "clean", "has its space cleaned"},
                  {Doing::Collides, "collide", "collides its space"},
                  {Doing::Asks, "ask", "queries its space"},
                  {Doing::Grows, "grow", "makes geoms of its space larger, which is refused when it is done", 45},
                  {Doing::Throws, "throw", "throws"},
                  {Doing::Jumps, "jump", "jumps out of the call"},
                  {Doing::Throws, "throw_among_many", "throws, in a large space", 12, BoxFunctions::kMany},
                  {Doing::Jumps, "jump_among_many", "jumps out of the call, in a large space", 12, BoxFunctions::kMany}};
    for (const auto &doing : doings)
        for (const SpaceKind kind : allSpaceKinds) {
            // Elsewhere than here, upstream's sweep-and-prune space then reads memory that it never wrote.
            if (kind == SpaceKind::SweepAndPrune && doing.doing != Doing::Cleans &&
                doing.doing != Doing::Grows)
                continue;
            catalogue.push_back(
                collisionScenario(std::string("box_functions/") + doing.name + "_in_" + nameOf(kind),
                                  std::string("a user's bounding-box function ") + doing.meaning, doing.frames,
                                  make<BoxFunctions>(kind, doing.doing, doing.geoms)));
            catalogue.back().leavesRuins = true;  // spaces that upstream cannot destroy any more
        }
}

}  // namespace exactness
