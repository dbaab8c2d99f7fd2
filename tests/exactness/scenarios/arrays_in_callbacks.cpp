#include "additions.h"
#include "ground_grid.h"
#include "prism.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <memory>

namespace exactness {

namespace {

// Near-callbacks change the arrays of geoms whose pairs come later in the same call: the pairs are known by then, and
// their contacts may have been computed.
class ArraysInCallbacks : public ManyParts {
public:
    void collide() override {
        m_pairs = 0;
        ManyParts::collide();
        note("pairs", m_pairs);
    }

protected:
    explicit ArraysInCallbacks(Stepper stepper, SpaceKind kind = SpaceKind::Hash) : ManyParts(stepper, kind) {
        addGround();
    }

    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (++m_pairs % 29 == 11) change(m_pairs / 29 + frameNumber());
        ManyParts::onNearPair(o1, o2);
    }

    virtual void change(int number) = 0;

private:
    int m_pairs = 0;
};

// Points and planes of convex geoms, in place or exchanged.
class ConvexArrays : public ArraysInCallbacks {
public:
    ConvexArrays(Stepper stepper, bool isInPlace) : ArraysInCallbacks(stepper), m_isInPlace(isInPlace) {
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                m_prisms.push_back(std::make_unique<Prism>(5 + i % 3, 0.3, 0.4));
                const dGeomID convex = m_prisms.back()->createGeom(space());
                carry(convex, origin + Vector3{dReal(0.02) * i, dReal(0.01) * part, dReal(0.25) + dReal(0.38) * i});
                m_convexes.push_back(convex);
            }
        });
    }

protected:
    void change(int number) override {
        const std::size_t which = (7 * number) % m_prisms.size();
        if (m_isInPlace)
            m_prisms[which]->setHeight(0.4 - 0.003 * (number % 9));
        else
            m_prisms[which]->giveTo(m_convexes[(which + 3 * number) % m_convexes.size()]);
    }

private:
    bool m_isInPlace;
    std::vector<std::unique_ptr<Prism>> m_prisms;
    std::vector<dGeomID> m_convexes;
};

// Vertices of a mesh under everything, or samples of a height field that are the program's own, or a copy that is rebuilt.
enum class Under { Mesh, OwnHeights, CopiedHeights };

class GroundArrays : public ArraysInCallbacks {
public:
    GroundArrays(Stepper stepper, Under under) : ArraysInCallbacks(stepper), m_under(under) {
        const Ground ground{65, 1.25, waves};
        HeightOptions options;
        options.isCopied = under == Under::CopiedHeights;
        if (under == Under::Mesh)
            m_mesh = std::make_shared<GridMesh>(ground);
        else
            m_heights = std::make_shared<HeightGrid>(ground, options);
        keep(m_mesh);
        keep(m_heights);
        const dGeomID geom = under == Under::Mesh
                                 ? dCreateTriMesh(space(), m_mesh->data(), nullptr, nullptr, nullptr)
                                 : m_heights->createGeom(space());
        dGeomSetPosition(add(geom), 30, 30, 0);
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i)
                carry(createShape(space(), allShapes[i % 4]),
                      origin + Vector3{dReal(0.9) * i, dReal(0.1) * part, 1.2});
        });
    }

protected:
    void change(int number) override {
        const auto shape = [number](int x, int y) { return waves(x, y) + 0.02 * ((x + y + number) % 5); };
        if (m_under == Under::Mesh)
            m_mesh->reshape(shape);
        else if (m_under == Under::OwnHeights)
            m_heights->reshape(shape);
        else
            m_heights->rebuild(shape);
    }

private:
    Under m_under;
    std::shared_ptr<GridMesh> m_mesh;
    std::shared_ptr<HeightGrid> m_heights;
};

}  // namespace

void addArraysInCallbacks(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 24, std::move(make)));
    };
    add("arrays_in_callbacks/convex_points", "callbacks write to the points of convex geoms", make<ConvexArrays>(true));
    add("arrays_in_callbacks/convex_exchanged", "callbacks give convex geoms other arrays", make<ConvexArrays>(false));
    add("arrays_in_callbacks/mesh", "callbacks move the vertices of a mesh", make<GroundArrays>(Under::Mesh));
    add("arrays_in_callbacks/heights", "callbacks write to the samples of a height field",
        make<GroundArrays>(Under::OwnHeights));
    add("arrays_in_callbacks/heights_rebuilt", "callbacks rebuild the data of a height field",
        make<GroundArrays>(Under::CopiedHeights));
}

}  // namespace exactness
