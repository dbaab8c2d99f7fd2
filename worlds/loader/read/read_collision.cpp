#include "loader/read/read_collision.h"

#include "loader/read/height_image.h"
#include "loader/read/mesh_file.h"
#include "loader/read/value_check.h"
#include "support/text.h"

namespace worlds {

namespace {

// element_rules.h has checked what is read here: types, ranges and names.

// Calls `read` with the file that a shape names. None for one that is missing or broken, if the user wants to do without.
template <class Read>
std::optional<Shape> readFile(const Element &shape, const Reading &reading, Read read) {
    const std::string &uri = shape.required("uri").text, &namedIn = shape.file().name;
    const std::string file = reading.resources.find(uri, namedIn);
    if (file.empty()) {
        reading.issues.missing(shape.place(), "no file " + support::quote(uri) + ": " + reading.resources.whereSearched(uri, namedIn));
        return std::nullopt;
    }
    try {
        return read(file);
    } catch (const LoadError &error) {
        if (error.kind() != LoadError::Kind::Resource) throw;
        reading.issues.missing(error);
        return std::nullopt;
    }
}

// None for what is not supported on a body that moves, and for <empty/>.
std::optional<Shape> readShape(const Element &shape, bool isStatic, const Reading &reading) {
    const std::string &kind = shape.name;
    if (kind == "box") return Box{shape.childVector("size", {1, 1, 1})};
    if (kind == "sphere") return Sphere{shape.childNumber("radius", 1)};
    if (kind == "cylinder") return Cylinder{shape.childNumber("radius", 1), shape.childNumber("length", 1)};
    if (kind == "capsule") return Capsule{shape.childNumber("radius", 0.5), shape.childNumber("length", 1)};
    if (kind == "mesh")
        return readFile(shape, reading, [&](const std::string &file) {
            return readMeshFile(file, shape.childVector("scale", {1, 1, 1}), shape.place());
        });
    if (kind == "empty") return std::nullopt;
    if (!isStatic) {
        reading.issues.unsupported(shape.parent->place(), "a shape without end on a body that moves");
        return std::nullopt;
    }
    if (kind == "plane") return Plane{shape.childVector("normal", {0, 0, 1}).normalized()};
    return readFile(shape, reading, [&](const std::string &file) {
        return readHeightImage(file, shape.childVector("size", {1, 1, 1}), shape.place());
    });
}

void readBounce(const Element &bounce, Surface &surface) {
    surface.restitution = bounce.childNumber("restitution_coefficient", surface.restitution);
    surface.bounceThreshold = bounce.childLimit("threshold", surface.bounceThreshold);
}

void readFriction(const Element &ode, Surface &surface) {
    surface.mu = limitOrNone(ode.childLimit("mu", surface.mu));
    // SDF gives mu2 a default of its own; who writes mu alone means both, as in ODE.
    surface.mu2 = limitOrNone(ode.childLimit("mu2", ode.child("mu") ? surface.mu : surface.mu2));
    surface.slip1 = ode.childNumber("slip1", surface.slip1);
    surface.slip2 = ode.childNumber("slip2", surface.slip2);
    if (const Element *direction = ode.child("fdir1")) {
        const Vector3 vector = ode.childVector("fdir1", {});
        surface.frictionDirection.reset();
        if (vector.length() > 0) surface.frictionDirection = vector.normalized();
        surface.frictionFrame.clear();
        for (const char *const attribute :
             {"ignition:expressed_in", "gz:expressed_in"})  // Gazebo's names for it
            if (const std::string *const frame = direction->findAttribute(attribute))
                surface.frictionFrame = *frame;
    }
}

void readSoftness(const Element &ode, Surface &surface, double stepSize) {
    if (ode.child("kp") || ode.child("kd")) {
        // A spring of stiffness kp with a damper kd, in one implicit step.
        const double kp = ode.childNumber("kp", 1e12), kd = ode.childNumber("kd", 1);
        surface.softErp = stepSize * kp / (stepSize * kp + kd);
        surface.softCfm = 1 / (stepSize * kp + kd);
    }
    if (const Element *erp = ode.child("soft_erp")) surface.softErp = erp->number();
    if (const Element *cfm = ode.child("soft_cfm")) surface.softCfm = cfm->number();
}

unsigned short maskOf(const Element &contact, const std::string &name, unsigned short otherwise) {
    const Element *const mask = contact.child(name);
    return mask ? static_cast<unsigned short>(readMask(mask->text)) : otherwise;
}

void readContact(const Element &contact, Surface &surface, double stepSize) {
    if (contact.child("collide_bitmask")) {
        surface.collide = maskOf(contact, "collide_bitmask", surface.collide);
        surface.category = surface.collide;  // SDF: the same unless given
    }
    surface.category = maskOf(contact, "category_bitmask", surface.category);
    surface.makesContacts = !contact.childFlag("collide_without_contact", !surface.makesContacts);
    if (const Element *ode = contact.child("ode")) readSoftness(*ode, surface, stepSize);
}

}  // namespace

Surface readSurface(const Element &element, Surface base, double stepSize) {
    if (const Element *bounce = element.child("bounce")) readBounce(*bounce, base);
    if (const Element *friction = element.child("friction"))
        if (const Element *ode = friction->child("ode")) readFriction(*ode, base);
    if (const Element *contact = element.child("contact")) readContact(*contact, base, stepSize);
    return base;
}

std::optional<Collision> readCollision(const Element &element, const Pose &pose, bool isStatic,
                                       const Physics &physics, const Reading &reading) {
    const Element &geometry = element.required("geometry");
    if (geometry.children.empty()) return std::nullopt;  // what was there is not supported
    const Element &shape = geometry.children.front();
    Collision collision;
    collision.name = element.attribute("name");
    collision.place = element.place();
    std::optional<Shape> read =
        withMemoryFor(collision.place, [&] { return readShape(shape, isStatic, reading); });
    if (!read) return std::nullopt;
    collision.shape = std::move(*read);
    collision.pose = pose;
    collision.pose.position += pose.rotation * shape.childVector("pos", {});  // of a height map
    collision.surface = physics.defaultSurface;
    if (const Element *const surface = element.child("surface"))
        collision.surface = readSurface(*surface, collision.surface, physics.stepSize);
    collision.maxContacts = static_cast<int>(element.childNumber("max_contacts", physics.maxContacts));
    return collision;
}

}  // namespace worlds
