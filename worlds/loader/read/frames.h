// Where everything is, and what it is attached to: SDF's frames. Every link, joint, model and <frame> is a
// frame with a pose relative to another one, and so are the model itself (__model__) and the world.
#pragma once

#include "loader/description/element.h"
#include "loader/description/geometry.h"

#include <memory>
#include <string>
#include <unordered_map>

namespace worlds {

// Numbers of a <pose>; null: none.
Pose readPose(const Element *pose);

// The link that a frame moves with. A null link is the world.
using Body = const Element *;

// The frames of a world or of one model, by their names in it. Of a model within, "model::frame" names a
// frame.
class Scope {
public:
    // Takes the frames of `element`, a checked <world> or <model>, and of the models inside. Keeps references
    // to the elements.
    explicit Scope(const Element &element);

    // Finds every frame's pose and link, so that what cannot be found is an error, whether it is used or not.
    // Throws LoadError.
    void resolve() const;

    // The pose of a link, joint, model or frame that is declared here, as it is seen from the model or world.
    const Pose &pose(const Element &declared) const;
    // The pose of a frame by name. `namedBy` is the element to blame when there is none, and `what` the
    // attribute of it, if any.
    Pose pose(const std::string &name, const Element &namedBy, const std::string &what = {}) const;
    // The link of a frame by name.
    Body body(const std::string &name, const Element &namedBy, const std::string &what = {}) const;

    // The frames of a model that is declared here.
    const Scope &inside(const Element &model) const { return *m_frames.at(&model).inside; }

private:
    struct Frame {
        const Element *element;
        std::unique_ptr<Scope> inside;  // of a model
        // Found when they are first asked for.
        mutable Pose pose;
        mutable Body body = nullptr;
        mutable bool hasPose = false, hasBody = false, isAsked = false;
    };
    // A frame by name: one of this scope, and what it takes from there to one inside it.
    struct Found {
        const Frame *frame;  // null: the model or world itself
        std::string inner;   // empty: the frame itself
    };
    // What a frame is relative or attached to, and who says so.
    struct Reference {
        std::string name;  // empty: the model or world itself
        const Element *namedBy;
        std::string what;
    };

    void addMerged(const Element &model);
    Found find(const Reference &reference) const;
    static Reference poseReference(const Frame &frame);
    static Reference bodyReference(const Frame &frame);
    [[noreturn]] static void failCycle(const Frame &frame, const std::string &what);
    void findPose(const Frame &frame) const;
    void findBody(const Frame &frame) const;
    Body ownBody(const Element &namedBy) const;
    const Element *canonicalLink() const;

    const Element &m_element;
    std::unordered_map<const Element *, Frame> m_frames;
    std::unordered_map<std::string, Found> m_names;
};

}  // namespace worlds
