// Levels of a hash space that change while it is collided.
//
// Covers api/collision_space.cpp.
#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"

namespace exactness {

namespace {

// Levels of a hash space are set in its callbacks, and the space collided again there.
class LevelsInCallbacks : public ManyParts {
public:
    LevelsInCallbacks(Stepper stepper, bool collidesAgain)
        : ManyParts(stepper, SpaceKind::Hash), m_collidesAgain(collidesAgain) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 6; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.05) * i, dReal(0.02) * part, dReal(0.3) + dReal(0.4) * i});
        });
    }

    void collide() override {
        m_pairs = 0;
        ManyParts::collide();
        note("pairs", m_pairs);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const int pair = ++m_pairs;
        if (!m_isInside && pair % 13 == 5) {
            dHashSpaceSetLevels(space(), -4 + (pair + frameNumber()) % 5, 1 + pair % 3);
            int low = 0, high = 0;
            dHashSpaceGetLevels(space(), &low, &high);
            note("levels", 100 * low + high);
            if (m_collidesAgain && frameNumber() % 4 == 1) collideInside();
        }
        ManyParts::onNearPair(o1, o2);
    }

private:
    void collideInside() {
        m_isInside = true;
        collideSpace(space());
        m_isInside = false;
    }

    bool m_collidesAgain, m_isInside = false;
    int m_pairs = 0;
};

}  // namespace

void addHashLevels(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 24, std::move(make)));
    };
    add("hash_levels/in_callbacks", "callbacks set the levels of their hash space",
        make<LevelsInCallbacks>(false));
    add("hash_levels/collided_again", "and collide it with the new levels", make<LevelsInCallbacks>(true));
}

}  // namespace exactness
