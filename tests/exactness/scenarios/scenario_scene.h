// What scenarios add to scenes::WorldScene: every part of a frame can be changed, objects can be
// destroyed, there may be more worlds and spaces, and the observer gets all events.
#pragma once

#include "scenes/world_scene.h"

#include <functional>
#include <list>

namespace exactness {

using scenes::SpaceKind;
using scenes::Stepper;
using scenes::Vector3;

class ScenarioScene : public scenes::WorldScene {
public:
    static constexpr dReal stepLength = 0.01;  // s

    explicit ScenarioScene(Stepper stepper, SpaceKind space = SpaceKind::Hash);
    ~ScenarioScene() override;

    void collide() override;
    void step() override;
    void finish() override;

protected:
    // --- objects beside those of WorldScene; all are listed and go with the scene -----------------
    dWorldID addWorld();
    dSpaceID addSpace(dSpaceID space);  // without a parent: one more that collide() goes through
    dBodyID addBody(Vector3 position, dWorldID world);  // no geom; 1 kg, inertia of a ball of radius 0.2
    dBodyID carry(dGeomID geom, Vector3 position);      // such a body, with this geom, which is listed
    dJointFeedback *addFeedback(dJointID joint);
    void addContactFeedback(dJointID contact);  // until the end of the frame

    void destroy(dBodyID body);  // with its geoms; its joints stay, attached to nothing
    void destroy(dJointID joint);
    void destroy(dGeomID geom);

    // --- parts of a frame, to be changed ----------------------------------------------------------
    virtual void onNearPair(dGeomID o1, dGeomID o2);  // by default: contacts for the pair
    virtual void setSurface(dContact &contact);       // by default: m_surface
    virtual void onContact(dJointID /*joint*/) {}     // of those that addContacts() makes
    virtual void stepWorld(dWorldID world);
    virtual void onMoved(dBodyID /*body*/) {}  // of the bodies that are watched

    // --- what such changes are made of ------------------------------------------------------------
    void collideSpace(dSpaceID space);
    void collideTwo(dGeomID one, dGeomID other);  // by dSpaceCollide2; not two geoms whose boxes may be old
    void addContacts(dGeomID o1, dGeomID o2);
    dJointID addContact(dContact &contact, dWorldID world);
    void tell(const dContact &contact);  // of which no joint is made
    void watchMoved(dBodyID body);
    void note(const char *what, double value = 0);
    void noteContactFeedback();
    Stepper stepper() const { return m_stepper; }
    int frameNumber() const { return m_frame; }  // of the frame in progress, from 1

    // The scene that lives: for callbacks that ODE gives no user data.
    static ScenarioScene &living();

    int m_contactLimit = 4;  // for a pair; any number

private:
    static void nearCallback(void *scene, dGeomID o1, dGeomID o2);
    static void movedCallback(dBodyID body);

    Stepper m_stepper;
    dJointGroupID m_group;
    std::vector<dSpaceID> m_roots;
    int m_frame = 1;
    std::list<dJointFeedback> m_feedbacks, m_contactFeedbacks;
};

// A scene of many parts that are too far apart to touch. Each part is an island of its own.
class ManyParts : public ScenarioScene {
public:
    using ScenarioScene::ScenarioScene;

protected:
    static constexpr int partCount = 16;

    // Calls build(number, origin) for every part; they are placed on a square grid.
    static void addParts(const std::function<void(int, Vector3)> &build, int count = partCount);
};

}  // namespace exactness
