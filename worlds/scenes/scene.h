// A scene: something the exactness suite, the bench and a viewer can all run.
//
// A scene owns ODE objects and knows how to advance them by one frame. A frame has four stages so
// that the bench can time each one apart, as the thesis does (collision, dynamics, overhead):
//
//   control()  motors, user forces, objects created or destroyed     (overhead)
//   collide()  dSpaceCollide and the creation of contact joints      (collision)
//   step()     dWorldStep or dWorldQuickStep of every world          (dynamics)
//   finish()   contact groups emptied, time advanced                 (overhead)
//
// Scenes use only the public API that all releases of ODE here have (ode/releases/): the same binary runs on Debian's libode8 and
// on ODE_MT. Scenes are deterministic: no clock, no address, no std::random_device decides anything.
//
// Threading: a scene is used from one thread at a time. dInitODE2 is the caller's job.
#pragma once

#include <atomic>
#include <ode/ode.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scenes {

enum class Stepper { World, Quick };

// The events that a scene reports to an observer. The exactness recorder hashes these events in the order
// in which they come; the bench leaves them unobserved.
class Observer {
public:
    virtual ~Observer() = default;
    virtual void nearPair(dGeomID /*o1*/, dGeomID /*o2*/) {}
    virtual void contact(const dContact & /*contact*/) {}
    virtual void bodyMoved(dBodyID /*body*/) {}
    virtual void note(const char * /*what*/, double /*value*/) {}  // any other event of a scene
};

// Everything whose state the recorder compares, in order of creation. ODE cannot list the bodies
// and joints of a world, so a scene keeps them. Contact joints are not listed: they are events.
struct Inventory {
    std::vector<dWorldID> worlds;
    std::vector<dSpaceID> spaces;
    std::vector<dBodyID> bodies;
    std::vector<dJointID> joints;
    std::vector<dGeomID> geoms;
    std::vector<dReal> readings;  // that sensors took in the last frame
};

class Scene {
public:
    virtual ~Scene() = default;
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    virtual void control() {}
    virtual void collide() = 0;
    virtual void step() = 0;
    virtual void finish() = 0;
    void frame();

    void observe(Observer *observer) { m_observer = observer; }  // not owned; null: unobserved
    const Inventory &inventory() const { return m_inventory; }
    double time() const { return m_time; }                   // s, of the simulated world
    dReal stepSize() const { return m_stepSize; }            // s
    std::size_t contactCount() const { return m_contacts; }  // contact joints made in the last frame

protected:
    explicit Scene(dReal stepSize) : m_stepSize(stepSize) {}

    Observer *m_observer = nullptr;
    Inventory m_inventory;
    double m_time = 0;
    dReal m_stepSize;
    std::atomic<std::size_t> m_contacts{0};  // callbacks may run on several threads
};

// A scene by name and size, "stacks:100" or "humanoids:22" or "pile:4000,quick". Throws
// std::invalid_argument that names what is wrong and lists what exists.
std::unique_ptr<Scene> makeScene(const std::string &description);

// Throws as makeScene does, but makes nothing.
void checkScene(const std::string &description);

struct SceneDescription {
    std::string name;     // "stacks"
    std::string meaning;  // one line for --help
};
std::vector<SceneDescription> availableScenes();
std::vector<SceneDescription> availableModifiers();  // what may follow a comma in a description

}  // namespace scenes
