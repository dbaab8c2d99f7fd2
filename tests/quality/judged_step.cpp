#include "judged_step.h"

#include <algorithm>
#include <chrono>
#include <climits>
#include <cmath>
#include <deque>
#include <stdexcept>

namespace quality {

namespace {

// QuickStep's order of rows is drawn; the same for all.
constexpr unsigned long kSeed = 1;

int placeOf(dBodyID body, const std::vector<dBodyID> &bodies) {
    if (body == nullptr) return ConstraintRow::kNone;
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    if (found == bodies.end()) throw std::logic_error("a contact's body is not in the scene's inventory");
    return int(found - bodies.begin());
}

// All joints' feedback, and which rows they have.
class Feedbacks {
public:
    ~Feedbacks() {
        for (const Entry &entry : m_entries) dJointSetFeedback(entry.joint, nullptr);
    }
    void add(dJointID joint, std::size_t firstRow, std::size_t endRow, bool isContact) {
        m_entries.push_back({joint, {}, firstRow, endRow, isContact});
        dJointSetFeedback(joint, &m_entries.back().feedback);
    }
    void readForces(std::vector<ConstraintRow> &rows) const {
        for (const Entry &entry : m_entries) {
            ConstraintRow *const first = rows.data() + entry.firstRow, *const end = rows.data() + entry.endRow;
            if (first == end) continue;
            if (entry.isContact)
                readContactForces(entry.feedback, first, end);
            else
                JointRows::readForces(entry.feedback, first, end);
        }
    }
    // Adds force and torque on each body.
    void addLoads(const std::vector<dBodyID> &bodies, std::vector<Velocity> &loads) const {
        for (const Entry &entry : m_entries)
            for (int side = 0; side < 2; ++side) {
                const dBodyID body = dJointGetBody(entry.joint, side);
                if (body == nullptr) continue;
                Velocity &load = loads[std::size_t(placeOf(body, bodies))];
                const dReal *const force = side == 0 ? entry.feedback.f1 : entry.feedback.f2;
                const dReal *const torque = side == 0 ? entry.feedback.t1 : entry.feedback.t2;
                for (int i = 0; i < 3; ++i) {
                    load.axis[i] += force[i];
                    load.axis[3 + i] += torque[i];
                }
            }
    }

private:
    struct Entry {
        dJointID joint;
        dJointFeedback feedback;
        std::size_t firstRow, endRow;
        bool isContact;
    };
    std::deque<Entry> m_entries;  // addresses stay
};

Velocity velocityOf(dBodyID body) {
    Velocity velocity;
    std::copy_n(dBodyGetLinearVel(body), 3, velocity.axis);
    std::copy_n(dBodyGetAngularVel(body), 3, velocity.axis + 3);
    return velocity;
}

// Force and torque that the user and gravity exert.
Velocity outerLoadOf(dBodyID body, dWorldID world) {
    Velocity load{};
    dVector3 gravity;
    dMass mass;
    dWorldGetGravity(world, gravity);
    dBodyGetMass(body, &mass);
    for (int i = 0; i < 3; ++i) {
        load.axis[i] = dBodyGetForce(body)[i] + (dBodyGetGravityMode(body) ? mass.mass * gravity[i] : 0);
        load.axis[3 + i] = dBodyGetTorque(body)[i];
    }
    return load;
}

}  // namespace

class JudgedScene::ContactLog final : public scenes::Observer {
public:
    explicit ContactLog(scenes::Scene &scene) : m_scene(scene) { scene.observe(this); }
    ~ContactLog() override { m_scene.observe(nullptr); }
    void contact(const dContact &contact) override { contacts.push_back(contact); }

    std::vector<dContact> contacts;

private:
    scenes::Scene &m_scene;
};

JudgedScene::JudgedScene(scenes::Scene &scene)
    : m_scene(scene), m_bodies(scene.inventory().bodies), m_joints(scene.inventory().joints), m_jointRows(m_joints) {
    for (const dBodyID body : m_bodies) {
        dBodySetDamping(body, 0, 0);
        dBodySetGyroscopicMode(body, 0);
    }
}

double JudgedScene::timedStep() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    m_scene.step();
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double JudgedScene::frame() {
    m_scene.control();
    m_scene.collide();
    const double seconds = timedStep();
    m_scene.finish();
    return seconds;
}

Judgement JudgedScene::judgedFrame(SavedProblem &problem) {
    m_scene.control();
    {
        ContactLog log(m_scene);
        m_scene.collide();
        problem = problemNow(log.contacts);
    }
    const Judgement judgement = step(problem.contacts, contactJoints(problem.contacts));
    m_scene.finish();
    return judgement;
}

Judgement JudgedScene::replay(const SavedProblem &problem) {
    if (problem.bodies.size() != m_bodies.size() || problem.joints.size() != m_joints.size())
        throw std::runtime_error("the problem is another scene's");
    for (std::size_t i = 0; i < m_bodies.size(); ++i) restore(m_bodies[i], problem.bodies[i]);
    for (std::size_t i = 0; i < m_joints.size(); ++i) restore(m_joints[i], problem.joints[i]);
    const dJointGroupID group = dJointGroupCreate(0);
    std::vector<dJointID> joints;
    for (const SavedContact &saved : problem.contacts) {
        const auto bodyAt = [&](int place) { return place == ConstraintRow::kNone ? nullptr : m_bodies[std::size_t(place)]; };
        joints.push_back(dJointCreateContact(m_scene.inventory().worlds.front(), group, &saved.contact));
        dJointAttach(joints.back(), bodyAt(saved.body[0]), bodyAt(saved.body[1]));
    }
    const Judgement judgement = step(problem.contacts, joints);
    dJointGroupDestroy(group);
    return judgement;
}

SavedProblem JudgedScene::problemNow(const std::vector<dContact> &contacts) const {
    SavedProblem problem;
    for (const dBodyID body : m_bodies) problem.bodies.push_back(stateOf(body));
    for (const dJointID joint : m_joints) problem.joints.push_back(stateOf(joint));
    for (const dContact &contact : contacts) {
        SavedContact saved{contact, {placeOf(dGeomGetBody(contact.geom.g1), m_bodies), placeOf(dGeomGetBody(contact.geom.g2), m_bodies)}};
        saved.contact.geom.g1 = saved.contact.geom.g2 = nullptr;
        problem.contacts.push_back(saved);
    }
    return problem;
}

// ODE puts a new joint in front of a body's others, so a body's contacts come last made first. A contact is found by that of its
// bodies that has fewer.
std::vector<dJointID> JudgedScene::contactJoints(const std::vector<SavedContact> &contacts) const {
    std::vector<dJointID> joints(contacts.size());
    std::vector<int> counts(m_bodies.size(), 0), next(m_bodies.size(), 0);
    const auto countOf = [&](int place) { return place == ConstraintRow::kNone ? INT_MAX : counts[std::size_t(place)]; };
    for (const SavedContact &saved : contacts)
        for (const int place : saved.body)
            if (place != ConstraintRow::kNone) ++counts[std::size_t(place)];
    for (std::size_t i = contacts.size(); i-- > 0;) {
        const int *const body = contacts[i].body;
        const std::size_t rarer = std::size_t(countOf(body[0]) <= countOf(body[1]) ? body[0] : body[1]);
        joints[i] = dBodyGetJoint(m_bodies[rarer], next[rarer]);
        if (dJointGetType(joints[i]) != dJointTypeContact) throw std::logic_error("a contact's joint was not found");
        for (const int place : contacts[i].body)
            if (place != ConstraintRow::kNone) ++next[std::size_t(place)];
    }
    return joints;
}

Judgement JudgedScene::step(const std::vector<SavedContact> &contacts, const std::vector<dJointID> &contactJoints) {
    const dWorldID world = m_scene.inventory().worlds.front();
    const double stepSize = m_scene.stepSize();
    const RowContext context{world, dReal(stepSize), m_bodies};
    std::vector<ConstraintRow> rows;
    Feedbacks feedbacks;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::size_t first = rows.size();
        appendContactRows(contacts[i], context, rows);
        feedbacks.add(contactJoints[i], first, rows.size(), true);
    }
    for (const dJointID joint : m_joints) {
        const std::size_t first = rows.size();
        m_jointRows.append(joint, context, rows);
        feedbacks.add(joint, first, rows.size(), false);
    }
    std::vector<InverseInertia> inertias;
    std::vector<Velocity> free, loads;
    for (const dBodyID body : m_bodies) {
        inertias.push_back(inverseInertiaOf(body));
        free.push_back(velocityOf(body));
        loads.push_back(outerLoadOf(body, world));
        double change[6];
        inertias.back().apply(loads.back().axis, change);
        for (int i = 0; i < 6; ++i) free.back().axis[i] += stepSize * change[i];
    }

    Judgement judgement;
    judgement.start = residualOf(rows, inertias, free, stepSize);
    dRandSetSeed(kSeed);
    judgement.seconds = timedStep();

    feedbacks.readForces(rows);
    loads.assign(loads.size(), {});
    feedbacks.addLoads(m_bodies, loads);
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        judgement.velocities.push_back(velocityOf(m_bodies[b]));
        double change[6];
        inertias[b].apply(loads[b].axis, change);
        for (int i = 0; i < 6; ++i) {
            const double moved = judgement.velocities[b].axis[i] - free[b].axis[i];
            judgement.change = std::max(judgement.change, std::fabs(moved));
            judgement.inconsistency = std::max(judgement.inconsistency, std::fabs(moved - stepSize * change[i]));
        }
    }
    judgement.residual = residualOf(rows, inertias, judgement.velocities, stepSize);
    return judgement;
}

}  // namespace quality
