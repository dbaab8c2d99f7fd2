#include "loader/read/read_surface.h"

namespace worlds {

namespace {

void readBounce(const Parameters &bounce, Surface &surface) {
    surface.restitution = bounce.childNumber("restitution_coefficient", surface.restitution);
    surface.bounceThreshold = bounce.childLimit("threshold", surface.bounceThreshold);
}

void readFriction(const Parameters &ode, Surface &surface) {
    surface.mu = ode.childLimit("mu", surface.mu);
    // SDF gives mu2 a default of its own; who writes mu alone means both, as in ODE.
    surface.mu2 = ode.childLimit("mu2", ode.child("mu") ? surface.mu : surface.mu2);
    surface.slip1 = ode.childNumber("slip1", surface.slip1);
    surface.slip2 = ode.childNumber("slip2", surface.slip2);
    if (const Parameters *direction = ode.child("fdir1")) {
        const std::vector<double> numbers = direction->numbers();
        const ignition::math::Vector3d vector(numbers[0], numbers[1], numbers[2]);
        surface.frictionDirection.reset();
        if (vector.Length() > 0) surface.frictionDirection = vector.Normalized();
        surface.frictionFrame.clear();
        for (const char *const attribute : {"ignition:expressed_in", "gz:expressed_in"})  // Gazebo's names for it
            if (direction->attributes.count(attribute)) surface.frictionFrame = direction->attribute(attribute);
    }
}

void readSoftness(const Parameters &ode, Surface &surface, double stepSize) {
    if (ode.child("kp") || ode.child("kd")) {
        // A spring of stiffness kp with a damper kd, in one implicit step.
        const double kp = ode.childNumber("kp", 1e12), kd = ode.childNumber("kd", 1);
        surface.softErp = stepSize * kp / (stepSize * kp + kd);
        surface.softCfm = 1 / (stepSize * kp + kd);
    }
    if (const Parameters *erp = ode.child("soft_erp")) surface.softErp = erp->number();
    if (const Parameters *cfm = ode.child("soft_cfm")) surface.softCfm = cfm->number();
}

unsigned short readMask(const Parameters &contact, const std::string &name, unsigned short otherwise) {
    return static_cast<unsigned short>(contact.childNumber(name, otherwise));
}

void readContact(const Parameters &contact, Surface &surface, double stepSize) {
    if (contact.child("collide_bitmask")) {
        surface.collide = readMask(contact, "collide_bitmask", surface.collide);
        surface.category = surface.collide;  // SDF: the same unless given
    }
    surface.category = readMask(contact, "category_bitmask", surface.category);
    if (const Parameters *ode = contact.child("ode")) readSoftness(*ode, surface, stepSize);
}

}  // namespace

Surface readSurface(const Parameters &element, Surface base, double stepSize) {
    if (const Parameters *bounce = element.child("bounce")) readBounce(*bounce, base);
    if (const Parameters *friction = element.child("friction"))
        if (const Parameters *ode = friction->child("ode")) readFriction(*ode, base);
    if (const Parameters *contact = element.child("contact")) readContact(*contact, base, stepSize);
    return base;
}

}  // namespace worlds
