#include "loader/read/frames.h"
#include "support/text.h"

#include <vector>

namespace worlds {

namespace {

const std::string kModelFrame = "__model__", kSeparator = "::";

bool isFrame(const Element &element) {
    return element.name == "link" || element.name == "joint" || element.name == "frame" ||
           element.name == "model";
}

[[noreturn]] void fail(const Element &namedBy, const std::string &what, const std::string &message) {
    namedBy.fail((what.empty() ? "" : what + ": ") + message);
}

}  // namespace

Pose readPose(const Element *pose) {
    if (!pose || pose->text.empty()) return {};
    const std::vector<double> n = pose->numbers();
    const Vector3 position{n[0], n[1], n[2]};
    if (pose->attributeOrEmpty("rotation_format") == "quat_xyzw")
        return {position, Quaternion{n[6], n[3], n[4], n[5]}.normalized()};
    const bool isInDegrees = isTrue(pose->attributeOrEmpty("degrees"));
    const auto angle = [&](double written) { return isInDegrees ? written * kPi / 180 : written; };
    return {position, Quaternion::fromRollPitchYaw(angle(n[3]), angle(n[4]), angle(n[5]))};
}

Scope::Scope(const Element &element) : m_element(element) {
    for (const Element &child : element.children) {
        if (!isFrame(child)) continue;
        Frame &frame = m_frames[&child];
        frame.element = &child;
        if (child.name == "model") frame.inside = std::make_unique<Scope>(child);
        if (child.isMerged)
            addMerged(child);
        else
            m_names.emplace(child.attribute("name"), Found{&frame, {}});
    }
}

// The frames of a merged model have their names here, too; itself is the frame that SDF says.
void Scope::addMerged(const Element &model) {
    const Frame &frame = m_frames.at(&model);
    m_names.emplace("_merged__" + model.attribute("name") + "__model__", Found{&frame, {}});
    for (const auto &[name, inner] : frame.inside->m_names) m_names.emplace(name, Found{&frame, name});
}

void Scope::resolve() const {
    for (const Element &child : m_element.children) {
        const auto found = m_frames.find(&child);
        if (found == m_frames.end()) continue;
        findPose(found->second);
        if (found->second.inside)
            found->second.inside->resolve();
        else
            findBody(found->second);
    }
    if (m_element.name == "model" && !m_element.attributeOrEmpty("canonical_link").empty()) canonicalLink();
}

const Pose &Scope::pose(const Element &declared) const {
    const Frame &frame = m_frames.at(&declared);
    findPose(frame);
    return frame.pose;
}

Pose Scope::pose(const std::string &name, const Element &namedBy, const std::string &what) const {
    const Found found = find({name, &namedBy, what});
    if (!found.frame) return {};
    findPose(*found.frame);
    return found.inner.empty() ? found.frame->pose
                               : found.frame->pose * found.frame->inside->pose(found.inner, namedBy, what);
}

Body Scope::body(const std::string &name, const Element &namedBy, const std::string &what) const {
    const Found found = find({name, &namedBy, what});
    if (!found.frame) return ownBody(namedBy);
    if (!found.inner.empty()) return found.frame->inside->body(found.inner, namedBy, what);
    findBody(*found.frame);
    return found.frame->body;
}

Scope::Found Scope::find(const Reference &reference) const {
    const bool isModel = m_element.name == "model";
    const std::string &name = reference.name;
    if (name.empty() || name == (isModel ? kModelFrame : "world")) return {nullptr, {}};
    if (const auto known = m_names.find(name); known != m_names.end()) return known->second;
    const std::size_t end = name.find(kSeparator);
    if (end != std::string::npos) {
        const auto outer = m_names.find(name.substr(0, end));
        if (outer != m_names.end() && outer->second.frame->inside)
            return {outer->second.frame,
                    (outer->second.inner.empty() ? "" : outer->second.inner + kSeparator) +
                        name.substr(end + kSeparator.size())};
    }
    fail(*reference.namedBy, reference.what,
         "no frame " + support::quote(name) + " in the " + m_element.name +
             (isModel ? " " + support::quote(m_element.attribute("name")) : std::string()));
}

Scope::Reference Scope::poseReference(const Frame &frame) {
    const Element &element = *frame.element, *const pose = element.child("pose");
    if (pose && !pose->attributeOrEmpty("relative_to").empty())
        return {pose->attribute("relative_to"), pose, "relative_to"};
    if (element.name == "joint" || element.name == "frame") return bodyReference(frame);
    return {{}, &element, {}};
}

Scope::Reference Scope::bodyReference(const Frame &frame) {
    const Element &element = *frame.element;
    if (element.name == "joint") return {element.required("child").text, &element.required("child"), {}};
    return {element.attributeOrEmpty("attached_to"), &element, "attached_to"};
}

void Scope::failCycle(const Frame &frame, const std::string &what) {
    frame.element->fail(what + " itself, in a cycle");
}

// Follows a chain of frames with a list instead of recursion: a file may hold a very long one.
void Scope::findPose(const Frame &frame) const {
    std::vector<const Frame *> chain;
    for (const Frame *at = &frame; at && !at->hasPose; at = find(poseReference(*at)).frame) {
        if (at->isAsked) failCycle(*at, "is relative to");
        at->isAsked = true;
        chain.push_back(at);
    }
    for (; !chain.empty(); chain.pop_back()) {
        const Frame &next = *chain.back();
        const Reference base = poseReference(next);
        next.pose = readPose(next.element->child("pose"));
        const Found found = find(base);
        if (found.frame)  // which has its pose
            next.pose =
                (found.inner.empty()
                     ? found.frame->pose
                     : found.frame->pose * found.frame->inside->pose(found.inner, *base.namedBy, base.what)) *
                next.pose;
        if (const std::string placed = next.element->attributeOrEmpty("placement_frame"); !placed.empty())
            next.pose = next.pose * next.inside->pose(placed, *next.element, "placement_frame").inverse();
        next.hasPose = true;
        next.isAsked = false;
    }
}

void Scope::findBody(const Frame &frame) const {
    std::vector<const Frame *> chain;
    const Frame *at = &frame;
    Body body = nullptr;
    while (!at->hasBody) {
        if (at->isAsked) failCycle(*at, "is attached to");
        at->isAsked = true;
        chain.push_back(at);
        if (at->element->name == "link") {
            body = at->element;
            break;
        }
        if (at->inside) {
            body = at->inside->ownBody(*at->element);
            break;
        }
        const Reference base = bodyReference(*at);
        const Found found = find(base);
        if (!found.frame || !found.inner.empty()) {
            body = found.frame ? found.frame->inside->body(found.inner, *base.namedBy, base.what)
                               : ownBody(*at->element);
            break;
        }
        at = found.frame;
    }
    if (at->hasBody) body = at->body;
    for (const Frame *known : chain) {
        known->body = body;
        known->hasBody = true;
        known->isAsked = false;
    }
}

// What the world, or a model as a whole, moves with.
Body Scope::ownBody(const Element &namedBy) const {
    if (m_element.name != "model") return nullptr;
    const Element *const link = canonicalLink();
    if (!link)
        fail(namedBy, {}, "the model " + support::quote(m_element.attribute("name")) + " has no link to move with");
    return link;
}

// The one that the model names, or its first one; of models inside when it has none itself. Null: none.
const Element *Scope::canonicalLink() const {
    if (const std::string name = m_element.attributeOrEmpty("canonical_link"); !name.empty()) {
        Found found = find({name, &m_element, "canonical_link"});
        while (!found.inner.empty())
            found = found.frame->inside->find({found.inner, &m_element, "canonical_link"});
        if (!found.frame || found.frame->element->name != "link")
            fail(m_element, "canonical_link", support::quote(name) + " is no link");
        return found.frame->element;
    }
    const Element *ofModels = nullptr;
    for (const Element &child : m_element.children) {
        if (child.name == "link") return &child;
        if (child.name != "model") continue;
        const Element *const inner = inside(child).canonicalLink();
        if (inner && child.isMerged) return inner;
        if (!ofModels) ofModels = inner;
    }
    return ofModels;
}

}  // namespace worlds
