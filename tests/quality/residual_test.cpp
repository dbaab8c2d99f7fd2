// The residual is rounding for solutions that are right, and no smaller than the defect for those that are not: the judge can fail.
#include "judged_scenes.h"
#include "judged_step.h"
#include "observation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace quality;

constexpr double kRounding = 1e-11;  // m/s

// A ball of 2 kg that falls on the ground at 1 m/s with a step of 0.01 s: the normal's row alone.
class FallingBall : public testing::Test {
protected:
    FallingBall() {
        ConstraintRow row;
        row.body[0] = 0;
        row.jacobian[0][2] = 1;
        row.low = 0;
        m_rows.push_back(row);
        m_inertias[0].mass = 0.5;
    }
    Residual residual(double force) {
        m_rows[0].force = force;
        return residualOf(m_rows, m_inertias, {{{0, 0, -1 + kStep * force * m_inertias[0].mass}}}, kStep);
    }

    static constexpr double kStep = 0.01, kRight = 200;  // s, N
    std::vector<ConstraintRow> m_rows;
    std::vector<InverseInertia> m_inertias{1};
};

TEST_F(FallingBall, HasTheForceThatStopsIt) {
    EXPECT_NEAR(residual(kRight).worst, 0, kRounding);
    EXPECT_NEAR(residual(kRight).energy, 0, kRounding);
}

TEST_F(FallingBall, IsTooSlowOrTooFastOtherwise) {
    EXPECT_NEAR(residual(0).worst, 1, kRounding);
    EXPECT_NEAR(residual(0).energy, 1, kRounding);  // of a ball of 2 kg at 1 m/s
    EXPECT_NEAR(residual(1.5 * kRight).worst, 0.5, kRounding);
}

TEST_F(FallingBall, MayLeaveButNotStick) {
    m_rows[0].c = -2;  // it may enter at 2 m/s: no force at all is right
    EXPECT_NEAR(residual(0).worst, 0, kRounding);
    EXPECT_NEAR(residual(10).worst, 0.05, kRounding);  // what that force does
}

TEST_F(FallingBall, SlidesWithAllFrictionOrNotAtAll) {
    ConstraintRow friction;
    friction.body[0] = 0;
    friction.jacobian[0][0] = 1;
    friction.low = -0.5;
    friction.high = 0.5;
    friction.normalRow = 0;
    m_rows.push_back(friction);
    m_rows[0].force = kRight;
    const auto slidingAt = [&](double velocity, double force) {
        m_rows[1].force = force;
        return residualOf(m_rows, m_inertias, {{{velocity, 0, 0}}}, kStep).worst;
    };
    EXPECT_NEAR(slidingAt(3, -0.5 * kRight), 0, kRounding);
    EXPECT_NEAR(slidingAt(-3, 0.5 * kRight), 0, kRounding);
    EXPECT_NEAR(slidingAt(0, 20), 0, kRounding);
    EXPECT_NEAR(slidingAt(3, 0), 0.5, kRounding);                // all friction could do
    EXPECT_NEAR(slidingAt(3, 0.5 * kRight), 1, kRounding);       // the wrong way
    EXPECT_NEAR(slidingAt(3, -kRight), 0.5, kRounding);          // more than friction can do
    EXPECT_NEAR(slidingAt(0.01, 20), 0.01, kRounding);           // creeps
}

TEST_F(FallingBall, NaNIsNoSolution) { EXPECT_TRUE(std::isinf(residual(NAN).worst)); }

// Another scene, with something done to it at each step.
class Spoiled final : public scenes::Scene {
public:
    Spoiled(scenes::Scene &scene, std::function<void()> before, std::function<void()> after)
        : Scene(scene.stepSize()), m_scene(scene), m_before(std::move(before)), m_after(std::move(after)) {
        m_inventory = scene.inventory();
    }
    void collide() override { m_scene.collide(); }
    void step() override {
        m_before();
        m_scene.step();
        m_after();
    }
    void finish() override { m_scene.finish(); }

private:
    scenes::Scene &m_scene;
    const std::function<void()> m_before, m_after;
};

class JudgedSteps : public testing::Test {
protected:
    JudgedSteps() {
        dInitODE2(0);
        dSetMessageHandler([](int, const char *, va_list) {});
    }
    ~JudgedSteps() override {
        dSetMessageHandler(nullptr);
        dCloseODE();
    }

    // A problem that the scene meets after some frames.
    static SavedProblem problemOf(const std::string &name) {
        const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(name, scenes::Stepper::Quick);
        JudgedScene judged(*scene);
        run(*scene, 80);
        SavedProblem problem;
        judged.judgedFrame(problem);
        return problem;
    }
    static Judgement solve(const std::string &name, const SavedProblem &problem, const Stepping &stepping) {
        const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(name, stepping.stepper);
        use(stepping, *scene);
        return JudgedScene(*scene).replay(problem);
    }
    static Judgement solveSpoiled(const std::string &name, const SavedProblem &problem, const std::function<void(scenes::Scene &)> &before,
                                  const std::function<void(scenes::Scene &)> &after) {
        const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(name, scenes::Stepper::World);
        Spoiled spoiled(*scene, [&] { before(*scene); }, [&] { after(*scene); });
        return JudgedScene(spoiled).replay(problem);
    }
};

TEST_F(JudgedSteps, ReplayIsTheStepItself) {
    const std::unique_ptr<scenes::Scene> scene = makeJudgedScene("ragdolls:2", scenes::Stepper::Quick);
    JudgedScene judged(*scene);
    run(*scene, 80);
    SavedProblem problem;
    const Judgement first = judged.judgedFrame(problem), again = solve("ragdolls:2", problem, {});
    EXPECT_GT(first.residual.rows, 50);
    EXPECT_NEAR(again.residual.worst / first.residual.worst, 1, 1e-6);
    EXPECT_NEAR(again.residual.energy / first.residual.energy, 1, 1e-6);
}

// dWorldQuickStep reaches the solution, in enough iterations: rows are those that the library has.
TEST_F(JudgedSteps, ManyIterationsLeaveRounding) {
    for (const char *const name : {"spheres:100", "chain:10", "ragdolls:2", "rolling", "bouncing", "rover:2"}) {
        SCOPED_TRACE(name);
        const SavedProblem problem = problemOf(name);
        const Judgement few = solve(name, problem, {scenes::Stepper::Quick, 20}), many = solve(name, problem, {scenes::Stepper::Quick, 100000});
        EXPECT_GT(few.residual.rows, 0);
        EXPECT_LT(many.residual.worst, kRounding);
        EXPECT_LT(many.residual.energy, kRounding * kRounding);
        EXPECT_LE(many.residual.worst, few.residual.worst);
    }
}

// dWorldStep does at once, where limits do not depend on the normals' forces.
TEST_F(JudgedSteps, WorldStepLeavesRounding) {
    for (const char *const name : {"fixed_friction", "chain:10"}) {
        SCOPED_TRACE(name);
        EXPECT_LT(solve(name, problemOf(name), {scenes::Stepper::World}).residual.worst, 1e-9);
    }
}

TEST_F(JudgedSteps, DefectsAreSeen) {
    const SavedProblem problem = problemOf("fixed_friction");
    const auto nothing = [](scenes::Scene &) {};
    const auto worldOf = [](scenes::Scene &scene) { return scene.inventory().worlds.front(); };
    const auto worst = [&](const std::function<void(scenes::Scene &)> &before, const std::function<void(scenes::Scene &)> &after) {
        return solveSpoiled("fixed_friction", problem, before, after).residual.worst;
    };
    const double right = worst(nothing, nothing);
    ASSERT_LT(right, 1e-9);
    // Forces and velocities that fit one another, but not the equations that the judge knows.
    EXPECT_GT(worst([&](scenes::Scene &scene) { dWorldSetContactSurfaceLayer(worldOf(scene), REAL(0.001)); }, nothing), 1e-4);
    // Gravity that the judge does not know of.
    const auto lighter = [&](scenes::Scene &scene) { dWorldSetGravity(worldOf(scene), 0, 0, REAL(-9.7)); };
    EXPECT_GT(solveSpoiled("fixed_friction", problem, lighter, nothing).inconsistency, 1e-4);
    // Velocities that are not those of the forces.
    const auto push = [](scenes::Scene &scene) {
        const dBodyID body = scene.inventory().bodies.front();
        const dReal *const v = dBodyGetLinearVel(body);
        dBodySetLinearVel(body, v[0], v[1], v[2] - REAL(1e-6));
    };
    EXPECT_GT(solveSpoiled("fixed_friction", problem, nothing, push).inconsistency, 0.9e-6);
    EXPECT_GT(worst(nothing, push), 1e-7);
}

}  // namespace
