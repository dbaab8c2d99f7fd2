// Meshes whose data are exchanged without a notification of their space.
//
// Covers api/collision_trimesh.cpp.
#include "additions.h"
#include "ground_grid.h"
#include "scenario_scene.h"
#include "shapes.h"
#include "spaces.h"

#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

namespace exactness {

namespace {

std::jmp_buf beforeTheCall;

dReal flat(int, int) { return 0; }

// Stacks, and a space in which nothing moves until a mesh is given other data, of which upstream does not
// tell the space. From then on the mesh keeps its place in the list, with the box that is queried, and what
// moves it does not notify the space either.
class Strays : public ManyParts {
public:
    ~Strays() override { dSetDebugHandler(nullptr); }

protected:
    Strays(Stepper stepper, SpaceKind kind, bool isNested)
        : ManyParts(stepper), m_small(grid(0.2)), m_large(grid(3)), m_kind(kind) {
        dSetDebugHandler(&handle);
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 4; ++i)
                carry(createShape(space(), allShapes[(part + i) % 4]),
                      origin + Vector3{dReal(0.03) * i, 0, dReal(0.3) + dReal(0.5) * i});
        });
        m_outer = createSpace(kind, nullptr);
        m_inner = isNested ? createSpace(kind, m_outer) : m_outer;
        for (int i = 0; i < 30; ++i) {
            const dGeomID ball = dCreateSphere(i % 3 == 0 ? m_inner : m_outer, 0.4);
            dGeomSetPosition(ball, i % 6, i / 6, 0);
            if (i % 7 == 3)
                m_meshes.push_back(dCreateTriMesh(m_inner, m_small->data(), nullptr, nullptr, nullptr));
            if (i % 7 == 3) dGeomSetPosition(m_meshes.back(), i % 6, i / 6, 0.3);
            m_balls.push_back(ball);
        }
        m_ray = dCreateRay(nullptr, 20);
        dGeomRaySet(m_ray, -1, 2, 0.1, 1, 0.1, 0);
    }

    template <class Call>
    void attempt(const Call &call) {
        if (setjmp(beforeTheCall) == 0) call();
    }

    void monitor() {
        m_pairs = OrderSum();
        attempt([this] { dSpaceCollide(m_outer, this, &meet); });
        attempt([this] { dSpaceCollide2(m_ray, reinterpret_cast<dGeomID>(m_outer), this, &meet); });
        if (m_inner != m_outer) attempt([this] { dSpaceCollide(m_inner, this, &meet); });
        attempt([this] { dSpaceCollide2(m_meshes[0], reinterpret_cast<dGeomID>(m_inner), this, &meet); });
        note("pairs", static_cast<double>(m_pairs.count()));
        note("sum of the pairs", m_pairs.value());
    }

    void giveData(int mesh, const GridMesh &data) { dGeomTriMeshSetData(m_meshes[mesh], data.data()); }
    void askForBox(int mesh) {
        dReal box[6];
        dGeomGetAABB(m_meshes[mesh], box);
        for (dReal bound : box) note("bound", bound);
    }
    void moveMesh(int mesh, dReal x) { dGeomSetPosition(m_meshes[mesh], x, 1, 0.2); }
    void moveBall(int ball, dReal z) { dGeomSetPosition(m_balls[ball], ball % 6, ball / 6, z); }

    std::shared_ptr<GridMesh> m_small, m_large;
    SpaceKind m_kind;
    dSpaceID m_outer, m_inner;
    std::vector<dGeomID> m_balls, m_meshes;
    dGeomID m_ray;

    static std::intptr_t nameOf(dGeomID geom, const Strays &scene) {
        if (dGeomIsSpace(geom)) return -1;
        if (geom == scene.m_ray) return -2;
        for (std::size_t i = 0; i < scene.m_balls.size(); ++i)
            if (scene.m_balls[i] == geom) return static_cast<std::intptr_t>(i);
        for (std::size_t i = 0; i < scene.m_meshes.size(); ++i)
            if (scene.m_meshes[i] == geom) return static_cast<std::intptr_t>(100 + i);
        return -3;
    }

private:
    std::shared_ptr<GridMesh> grid(dReal pitch) {
        const auto made = std::make_shared<GridMesh>(Ground{3, pitch, flat});
        keep(made);
        return made;
    }

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        Strays &scene = *static_cast<Strays *>(data);
        scene.m_pairs.add(1000 * nameOf(o1, scene) + nameOf(o2, scene));
        if (dGeomIsSpace(o1) || dGeomIsSpace(o2)) dSpaceCollide2(o1, o2, data, &meet);
    }

    static void handle(int number, const char *format, va_list arguments) {
        char text[300];
        std::vsnprintf(text, sizeof(text), format, arguments);
        for (char *at = text; *at != 0; ++at)
            if (*at == '[') *at = 0;  // file and line
        static_cast<Strays &>(living()).note(text, number);
        std::longjmp(beforeTheCall, 1);
    }

    OrderSum m_pairs;
};

// The box is queried before the space collides: upstream finds the new pairs from then on.
class Asked : public Strays {
public:
    Asked(Stepper stepper, SpaceKind kind, bool isNested) : Strays(stepper, kind, isNested) {}

    void control() override {
        attempt([this] { change(frameNumber()); });
        monitor();
    }

private:
    void change(int frame) {
        if (frame == 4) giveData(0, *m_large);
        if (frame >= 4) askForBox(0);
        if (frame == 8) giveData(1, *m_large);
        if (frame >= 8) askForBox(1);
        if (frame == 10) giveData(0, *m_small);
        if (frame == 10) askForBox(0);
        if (frame == 12) moveBall(5, 0.2);
        if (frame == 14) {
            moveMesh(1, 4);
            askForBox(1);
            moveBall(9, 0.1);
        }
        if (frame == 16) dGeomDisable(m_meshes[1]);
        if (frame == 18) dGeomEnable(m_meshes[1]);
        if (frame == 20)
            for (int ball = 0; ball < 30; ++ball) moveBall(ball, 0.01 * ball);
        if (frame == 22) {  // the stray leaves, and comes back
            dSpaceRemove(m_inner, m_meshes[1]);
            dSpaceAdd(m_inner, m_meshes[1]);
        }
        if (frame == 24) moveMesh(1, 2);
        if (frame == 26) {
            dSpaceRemove(m_inner, m_meshes[0]);
            dSpaceAdd(m_inner, m_meshes[0]);
        }
    }
};

// No code queries the box: upstream asserts wherever it reaches the mesh, and the handler jumps out of each
// call, which leaves spaces locked.
class Unasked : public Strays {
public:
    Unasked(Stepper stepper, SpaceKind kind, bool isNested) : Strays(stepper, kind, isNested) {}

    void control() override {
        if (frameNumber() == 5) attempt([this] { giveData(0, *m_large); });
        monitor();
    }
};

// Calls that are refused too late: the geom is marked as moved, and its space is not notified. Later it is asked
// for its box.
class HalfRefused : public Strays {
public:
    HalfRefused(Stepper stepper, SpaceKind kind) : Strays(stepper, kind, false) {}

    void control() override {
        const int frame = frameNumber();
        if (frame == 5 || frame == 9) dSpaceCollide(m_outer, this, &disturb);
        m_isDisturbed = false;
        attempt([this, frame] { change(frame); });
        monitor();
    }

private:
    void change(int frame) {
        for (int mesh = 0; mesh < 4; ++mesh) askForBox(mesh);
        dReal box[6];
        for (dGeomID ball : m_balls) dGeomGetAABB(ball, box);
        if (frame == 12) moveBall(11, 0.3);
        if (frame == 12) dGeomGetAABB(m_balls[11], box);
    }

    // In the first callback, after which no other geom is disturbed; then the rest of the call is left.
    static void disturb(void *data, dGeomID, dGeomID) {
        HalfRefused &scene = *static_cast<HalfRefused *>(data);
        if (scene.m_isDisturbed) return;
        scene.m_isDisturbed = true;
        const int ball = scene.frameNumber();
        dReal box[6];
        scene.attempt([&] { dGeomSphereSetRadius(scene.m_balls[ball], 1.2); });
        dGeomGetAABB(scene.m_balls[ball], box);
        scene.attempt([&] { dGeomSetPosition(scene.m_balls[ball + 1], 0, 0, 0); });
        scene.attempt([&] { scene.giveData(2, *scene.m_large); });
        dGeomGetAABB(scene.m_meshes[2], box);
    }

    bool m_isDisturbed = false;
};

// The same, but callbacks continue, and no code queries boxes: the assertion fails at the next pair of the geom. Of the space
// that is collided, or of one inside it.
class HalfRefusedOnward : public Strays {
public:
    HalfRefusedOnward(Stepper stepper, SpaceKind kind, bool asks) : Strays(stepper, kind, true), m_asks(asks) {}

    void control() override {
        if (frameNumber() == 4) attempt([this] { dSpaceCollide(m_outer, this, &disturb); });
        note("pairs before", m_before);
        monitor();
    }

private:
    static void disturb(void *data, dGeomID o1, dGeomID o2) {
        HalfRefusedOnward &scene = *static_cast<HalfRefusedOnward *>(data);
        scene.noteIt(o1, o2);
        if (++scene.m_before != 9) return;
        std::jmp_buf outer;
        std::memcpy(&outer, &beforeTheCall, sizeof outer);
        dReal box[6];
        scene.attempt([&] { dGeomSphereSetRadius(scene.m_balls[10], 1.1); });
        if (scene.m_asks) dGeomGetAABB(scene.m_balls[10], box);
        scene.attempt([&] { dGeomSetPosition(scene.m_balls[6], 0.2, 1, 0); });
        if (scene.m_asks) dGeomGetAABB(scene.m_balls[6], box);
        std::memcpy(&beforeTheCall, &outer, sizeof outer);
    }

    void noteIt(dGeomID o1, dGeomID o2) {
        note("first", static_cast<double>(nameOf(o1, *this)));
        note("second", static_cast<double>(nameOf(o2, *this)));
    }

    bool m_asks;
    int m_before = 0;
};

// Callbacks switch geoms of the space on and off, and give a mesh of another space other data: upstream's hash and
// sweep-and-prune spaces have asked by then which geoms are enabled, its other spaces ask at each pair.
class Switched : public Strays {
public:
    Switched(Stepper stepper, SpaceKind kind) : Strays(stepper, kind, false) {
        m_elsewhere = createSpace(kind, nullptr);
        m_mesh = dCreateTriMesh(m_elsewhere, m_small->data(), nullptr, nullptr, nullptr);
        dSpaceClean(m_elsewhere);
        for (const dGeomID ball : m_balls) dGeomSphereSetRadius(ball, 0.9);
    }

protected:
    void control() override {
        for (std::size_t i = 0; i < m_balls.size(); ++i) moveBall(static_cast<int>(i), 0.01 * (frameNumber() % 5));
        m_seen = 0;
        m_isInner = false;
        dSpaceCollide(m_outer, this, &change);
        note("pairs", m_seen);
    }

private:
    static void change(void *data, dGeomID o1, dGeomID o2) {
        Switched &scene = *static_cast<Switched *>(data);
        scene.note("first", static_cast<double>(nameOf(o1, scene)));
        scene.note("second", static_cast<double>(nameOf(o2, scene)));
        const int turn = scene.m_seen++ + scene.frameNumber();
        const dGeomID ball = scene.m_balls[(5 * turn) % scene.m_balls.size()];
        (dGeomIsEnabled(ball) ? dGeomDisable : dGeomEnable)(ball);
        if (turn % 9 != 4) return;
        dGeomTriMeshSetData(scene.m_mesh, turn % 2 == 0 ? scene.m_large->data() : scene.m_small->data());
        if (scene.m_isInner || turn % 2 != 0) return;
        scene.m_isInner = true;
        dSpaceCollide(scene.m_outer, data, &change);
        scene.m_isInner = false;
    }

    dSpaceID m_elsewhere;
    dGeomID m_mesh;
    int m_seen = 0;
    bool m_isInner = false;
};

// In each frame a row of balls in a space of its own, each of which overlaps the next one, is collided some times, and then something happens in a
// callback. Bits exclude most pairs, or none.
class Rows : public Strays {
public:
    enum class Event { grow, loseSize, collideWithin };

    Rows(Stepper stepper, SpaceKind kind, Event event) : Strays(stepper, kind, false), m_event(event) {}

protected:
    void control() override {
        const int wanted = frameNumber() % 2 == 0 ? kBalls : 2;
        const dSpaceID row = createSpace(m_kind, nullptr);
        m_row.clear();
        for (int i = 0; i < kBalls; ++i) {
            m_row.push_back(dCreateSphere(row, 0.5));
            dGeomSetPosition(m_row[i], 0.9 * i, 0, 0);
            if (i >= wanted) dGeomSetCategoryBits(m_row[i], 0), dGeomSetCollideBits(m_row[i], 0);
        }
        if (m_event == Event::collideWithin) dGeomDisable(m_row[frameNumber() % kBalls]);
        for (int call = 0; call < kCallsAtRest; ++call) dSpaceCollide(row, this, &notice);
        m_met = 0;
        attempt([&] { dSpaceCollide(row, this, &disturb); });
    }

private:
    static constexpr int kBalls = 8, kCallsAtRest = 6;

    static void notice(void *data, dGeomID o1, dGeomID o2) { static_cast<Rows *>(data)->noteIt(o1, o2); }
    static void disturb(void *data, dGeomID o1, dGeomID o2) {
        Rows &scene = *static_cast<Rows *>(data);
        scene.noteIt(o1, o2);
        if (scene.m_met++ != scene.frameNumber() % 3 % (scene.frameNumber() % 2 == 0 ? 3 : 1)) return;
        std::jmp_buf outer;
        std::memcpy(&outer, &beforeTheCall, sizeof outer);
        const dGeomID ball = scene.m_row[static_cast<std::size_t>(scene.frameNumber() * 3 % kBalls)];
        switch (scene.m_event) {
            case Event::grow: scene.attempt([&] { dGeomSphereSetRadius(ball, 0.6); }); break;
            case Event::loseSize: scene.attempt([&] { dGeomSphereSetRadius(ball, 0); }); break;
            default:
                scene.attempt([&] {
                    for (const dGeomID each : scene.m_row) dGeomEnable(each);
                    if (scene.frameNumber() % 4 == 1) dGeomDisable(ball);
                    dSpaceCollide(dGeomGetSpace(ball), data, &notice);
                });
        }
        std::memcpy(&beforeTheCall, &outer, sizeof outer);
    }

    void noteIt(dGeomID o1, dGeomID o2) {
        for (const dGeomID geom : {o1, o2}) note("ball", dGeomGetPosition(geom)[0]);
    }

    Event m_event;
    std::vector<dGeomID> m_row;
    int m_met = 0;
};

// A clean geom comes into a list in front of one that has changed, which is cleaned no more, and whose next moves the
// spaces around the list do not hear of.
class CleanInFront : public Strays {
public:
    CleanInFront(Stepper stepper, SpaceKind kind, bool asks) : Strays(stepper, kind, false), m_asks(asks) {
        m_list = createSpace(SpaceKind::Simple, m_outer);
        for (int i = 0; i < kListed; ++i) {
            m_listed.push_back(dCreateSphere(m_list, 0.5));
            place(i, 0);
        }
    }

protected:
    void control() override {
        attempt([this] { change(frameNumber() % 6, frameNumber() / 6); });
        monitor();
    }

private:
    static constexpr int kListed = 5;

    void change(int turn, int round) {
        const int changed = round % kListed, clean = (changed + 1) % kListed;
        switch (turn) {
            case 1:
                place(changed, 0.3);
                putInFront(clean);
                return ask();
            case 2:
            case 3:
                place(changed, 0.3 + turn);
                return ask();
            case 4:  // the changed one is the first again, but for the clean ones
                for (int i = 0; i < kListed; ++i)
                    if (i != changed) putInFront(i);
                for (int i = 0; i < kListed; ++i)
                    if (i != changed) dSpaceRemove(m_list, m_listed[i]);
                return;
            case 5:
                for (int i = 0; i < kListed; ++i)
                    if (i != changed) dSpaceAdd(m_list, m_listed[i]);
                return;
            default:
                return;
        }
    }

    void place(int listed, dReal x) { dGeomSetPosition(m_listed[listed], x + listed, 2.5, 0.1); }
    void putInFront(int listed) {
        dSpaceRemove(m_list, m_listed[listed]);
        dSpaceAdd(m_list, m_listed[listed]);
    }
    void ask() {
        dReal box[6];
        if (m_asks) dGeomGetAABB(reinterpret_cast<dGeomID>(m_list), box);
    }

    bool m_asks;
    dSpaceID m_list;
    std::vector<dGeomID> m_listed;
};

}  // namespace

void addStrayGeoms(Catalogue &catalogue) {
    const struct {
        SpaceKind kind;
        const char *in, *meaning;
    } kinds[] = {{SpaceKind::Simple, "simple", "a simple space"},
                 {SpaceKind::Hash, "hash", "a hash space"},
                 {SpaceKind::SweepAndPrune, "sweep_and_prune", "a sweep-and-prune space"},
                 {SpaceKind::QuadTree, "quad_tree", "a quad-tree space"}};
    for (const auto &each : kinds) {
        const auto add = [&](const std::string &what, const std::string &meaning, Scenario::Make make) {
            catalogue.push_back(collisionScenario("stray_geoms/" + what + "_in_" + each.in,
                                                  meaning + " in " + each.meaning, 30, std::move(make)));
        };
        add("asked", "a mesh gets other data without a notification, and its box is queried",
            make<Asked>(each.kind, false));
        add("asked_nested", "the same with a space inside, which is stray, too",
            make<Asked>(each.kind, true));
        catalogue.back().leavesRuins = true;
        add("unasked", "a mesh gets other data without a notification, and an assertion fails",
            make<Unasked>(each.kind, false));
        catalogue.back().leavesRuins = true;
        add("unasked_nested", "the same with a space inside", make<Unasked>(each.kind, true));
        catalogue.back().leavesRuins = true;
        add("onward", "what a locked space refuses too late, and callbacks continue", make<HalfRefusedOnward>(each.kind, true));
        catalogue.back().leavesRuins = true;
        add("onward_unasked", "the same with boxes that are not up to date", make<HalfRefusedOnward>(each.kind, false));
        catalogue.back().leavesRuins = true;
        add("switched", "geoms enabled and disabled, and another mesh that gets other data, in callbacks", make<Switched>(each.kind));
        add("row_grown", "a callback resizes one of a row at rest", make<Rows>(each.kind, Rows::Event::grow));
        catalogue.back().leavesRuins = true;
        add("row_without_size", "a callback takes one of a row its size", make<Rows>(each.kind, Rows::Event::loseSize));
        catalogue.back().leavesRuins = true;
        add("row_within", "a callback enables some of a row and collides it", make<Rows>(each.kind, Rows::Event::collideWithin));
        catalogue.back().leavesRuins = true;
        add("clean_in_front", "a clean geom is added to a list in front of one that has changed", make<CleanInFront>(each.kind, true));
        add("clean_in_front_unasked", "the same with boxes that are not up to date", make<CleanInFront>(each.kind, false));
        catalogue.back().leavesRuins = true;
        add("half_refused", "what a locked space refuses too late", make<HalfRefused>(each.kind));
    }
}

}  // namespace exactness
