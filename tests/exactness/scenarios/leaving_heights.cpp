#include "additions.h"
#include "left_call.h"
#include "order_sum.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

namespace exactness {

namespace {

enum class Leaving { throws, jumps, asks };

// A function for the heights of a field that leaves while upstream has turned a geom into the field's frame, or asks the
// space of that geom meanwhile. The geom remains transformed, and its space is not notified.
class LeavingHeights : public ManyParts {
public:
    LeavingHeights(Stepper stepper, SpaceKind kind, Leaving leaving)
        : ManyParts(stepper), m_leaving(leaving), m_space(createSpace(kind, nullptr)), m_data(dGeomHeightfieldDataCreate()) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            carry(createShape(space(), allShapes[part % 4]), origin + Vector3{0, 0, dReal(0.5)});
        });
        dGeomHeightfieldDataBuildCallback(m_data, this, &height, kSide, kSide, kSamples, kSamples, 1, 0, 0, 0);
        dGeomHeightfieldDataSetBounds(m_data, -1, 1);
        m_terrain = dCreateHeightfield(nullptr, m_data, 1);
        dMatrix3 upright;
        dRFromAxisAndAngle(upright, 1, 0, 0, M_PI / 2);
        dGeomSetRotation(m_terrain, upright);
        for (int i = 0; i < kGeoms; ++i) addGeom(i);
        m_probe = dCreateBox(nullptr, 3, 3, 3);
    }
    ~LeavingHeights() override {
        dGeomDestroy(m_probe);
        dGeomDestroy(m_terrain);
        dSpaceDestroy(m_space);
        dGeomHeightfieldDataDestroy(m_data);
    }

    void control() override {
        const int frame = frameNumber();
        m_pairs = OrderSum();
        dSpaceCollide(m_space, this, &meet);
        m_heightsToCome = frame % 3;
        attempt([&] { touch(m_geoms[(7 * frame) % kGeoms]); });
        m_heightsToCome = -1;
        ask();
        if (frame % 4 == 0) dGeomSetPosition(m_geoms[(7 * frame) % kGeoms], dReal(frame % 5), 0, dReal(0.2));
        ask();
        note("pairs", static_cast<double>(m_pairs.count()));
        note("sum of the pairs", m_pairs.value());
    }

private:
    static constexpr int kSide = 20, kSamples = 21, kGeoms = 30;

    void addGeom(int number) {
        const dGeomID geom = dCreateSphere(m_space, dReal(0.6));
        dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(number)));
        dGeomSetPosition(geom, dReal(number % 6) - 3, dReal(number / 6) - 3, 0);
        m_geoms.push_back(geom);
    }

    void touch(dGeomID geom) {
        dContactGeom contacts[8];
        note("contacts", dCollide(m_terrain, geom, 8, contacts, sizeof(dContactGeom)));
    }

    void ask() {
        dSpaceCollide(m_space, this, &meet);
        for (int i = 0; i < 4; ++i) {
            dGeomSetPosition(m_probe, dReal(5 * i), dReal(3 * i), 0);
            dSpaceCollide2(m_probe, reinterpret_cast<dGeomID>(m_space), this, &meet);
        }
        // A member queries the space, where upstream knows its block.
        dSpaceCollide2(m_geoms[frameNumber() % kGeoms], reinterpret_cast<dGeomID>(m_space), this, &meet);
    }

    static dReal height(void *scene, int x, int z) {
        static_cast<LeavingHeights *>(scene)->onHeight();
        return dReal(0.05) * dReal((3 * x + 5 * z) % 7);
    }

    void onHeight() {
        if (m_heightsToCome < 0 || m_heightsToCome-- > 0) return;
        switch (m_leaving) {
            case Leaving::throws:
                throw 1;
            case Leaving::jumps:
                std::longjmp(beforeTheCall, 1);
            case Leaving::asks:
                ask();
        }
    }

    template <class Call>
    void attempt(const Call &call) {
        if (throwsAnInt(call)) note("thrown");
    }

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        const auto name = [](dGeomID geom) { return reinterpret_cast<std::intptr_t>(dGeomGetData(geom)); };
        static_cast<LeavingHeights *>(data)->m_pairs.add(1000 * name(o1) + name(o2));
    }

    const Leaving m_leaving;
    dSpaceID m_space;
    dHeightfieldDataID m_data;
    dGeomID m_terrain, m_probe;
    std::vector<dGeomID> m_geoms;
    int m_heightsToCome = -1;  // -1: none leaves
    OrderSum m_pairs;
};

}  // namespace

void addLeavingHeights(Catalogue &catalogue) {
    const struct {
        Leaving leaving;
        const char *name, *meaning;
    } ways[] = {{Leaving::throws, "throw", "throws"},
                {Leaving::jumps, "jump", "jumps out of the call"},
                {Leaving::asks, "ask", "queries the geom's space"}};
    for (const auto &way : ways)
        for (const SpaceKind kind : allSpaceKinds)
            catalogue.push_back(collisionScenario(std::string("leaving_heights/") + way.name + "_in_" + nameOf(kind),
                                                  std::string("a height field's function ") + way.meaning +
                                                      " while a geom is transformed into the field's frame",
                                                  40, make<LeavingHeights>(kind, way.leaving)));
}

}  // namespace exactness
