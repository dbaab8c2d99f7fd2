#include "loader/scene/contact_rules.h"

#include "loader/scene/ode_types.h"

#include <algorithm>
#include <numeric>

namespace worlds {

namespace {

// SDF lets two shapes touch when the category of one matches the collide mask of the other, and so does ODE.
// Masks have 16 bits; the 16 above them let static geoms keep that rule against moving ones while
// they have no collide bits that match one another.
constexpr int upperMask = 16;

void setBits(dGeomID geom, const Surface &surface, bool isStatic, bool meetsStatic) {
    const unsigned long category = surface.makesContacts ? surface.category : 0, collide = surface.makesContacts ? surface.collide : 0;
    dGeomSetCategoryBits(geom, isStatic ? category | collide << upperMask : category);
    dGeomSetCollideBits(geom, meetsStatic ? collide | category << upperMask : 0);
}

template <class Value, class Choose>
std::optional<Value> choose(const std::optional<Value> &a, const std::optional<Value> &b, Choose better) {
    if (!a || !b) return a ? a : b;
    return better(*a, *b);
}

Vector3 rotate(const dReal *q, const Vector3 &vector) {
    return toQuaternion(q) * vector;
}

}  // namespace

void ContactRules::add(dGeomID geom, const Link &link, const Collision &collision) {
    m_properties.push_back({collision.surface, collision.maxContacts, link.model, link.selfCollide, std::nullopt, nullptr});
    if (link.isStatic) m_properties.back().rotation = link.pose.rotation * collision.pose.rotation;
    dGeomSetData(geom, &m_properties.back());
    setBits(geom, collision.surface, link.isStatic, !link.isStatic || m_staticMeetsStatic);
}

const ContactRules::Properties &ContactRules::of(dGeomID geom) {
    return *static_cast<const Properties *>(dGeomGetData(geom));
}

void ContactRules::setFrictionFrame(dGeomID geom, dBodyID body) {
    static_cast<Properties *>(dGeomGetData(geom))->frictionFrame = body;
}

Vector3 ContactRules::frictionDirection(dGeomID geom) {
    const Properties &properties = of(geom);
    const Vector3 &direction = *properties.surface.frictionDirection;
    if (properties.frictionFrame) return rotate(dBodyGetQuaternion(properties.frictionFrame), direction);
    if (properties.rotation) return *properties.rotation * direction;
    dQuaternion q;
    dGeomGetQuaternion(geom, q);
    return rotate(q, direction);
}

bool ContactRules::mayTouch(dGeomID geom1, dGeomID geom2) {
    const dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
    if (!body1 || !body2) return body1 || body2;
    const Properties &first = of(geom1), &second = of(geom2);
    if (first.model == second.model && !first.selfCollide && !second.selfCollide) return false;
    return !dAreConnectedExcluding(body1, body2, dJointTypeContact);
}

int ContactRules::maxContacts(dGeomID geom1, dGeomID geom2) {
    return std::min(of(geom1).maxContacts, of(geom2).maxContacts);
}

dSurfaceParameters ContactRules::surface(dGeomID geom1, dGeomID geom2) const {
    const Surface &a = of(geom1).surface, &b = of(geom2).surface;
    const auto lesser = [](double x, double y) { return std::min(x, y); };
    const auto greater = [](double x, double y) { return std::max(x, y); };

    dSurfaceParameters pair{};
    pair.mode = m_frictionPyramid ? dContactApprox1 : 0;
    pair.mu = toReal(std::min(a.mu, b.mu));
    pair.mu2 = toReal(std::min(a.mu2, b.mu2));
    if (pair.mu != pair.mu2) pair.mode |= dContactMu2;
    pair.slip1 = toReal(a.slip1 + b.slip1);
    if (pair.slip1 > 0) pair.mode |= dContactSlip1;
    pair.slip2 = toReal(a.slip2 + b.slip2);
    if (pair.slip2 > 0) pair.mode |= dContactSlip2;
    pair.bounce = toReal(std::min(a.restitution, b.restitution));
    pair.bounce_vel = toReal(std::max(a.bounceThreshold, b.bounceThreshold));
    if (pair.bounce > 0) pair.mode |= dContactBounce;
    if (const std::optional<double> erp = choose(a.softErp, b.softErp, lesser)) {
        pair.soft_erp = toReal(*erp);
        pair.mode |= dContactSoftERP;
    }
    if (const std::optional<double> cfm = choose(a.softCfm, b.softCfm, greater)) {
        pair.soft_cfm = toReal(*cfm);
        pair.mode |= dContactSoftCFM;
    }
    return pair;
}

void ContactRules::setDirection(dContact &contact) {
    const bool first = of(contact.geom.g1).surface.frictionDirection.has_value();
    if (!first && !of(contact.geom.g2).surface.frictionDirection) return;
    const Vector3 direction = frictionDirection(first ? contact.geom.g1 : contact.geom.g2);
    const Vector3 normal = toVector(contact.geom.normal);
    Vector3 tangent = direction - normal * normal.dot(direction);
    if (tangent.length() < 1e-6) return;  // along the normal: ODE takes a direction of its own
    tangent = tangent.normalized();
    contact.fdir1[0] = toReal(tangent.x);
    contact.fdir1[1] = toReal(tangent.y);
    contact.fdir1[2] = toReal(tangent.z);
    contact.surface.mode |= dContactFDir1;
}

std::vector<int> deepestContacts(const std::vector<dContact> &contacts, int count, int limit) {
    std::vector<int> chosen(static_cast<std::size_t>(count));
    std::iota(chosen.begin(), chosen.end(), 0);
    if (count <= limit) return chosen;
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](int a, int b) { return contacts[a].geom.depth > contacts[b].geom.depth; });
    chosen.resize(static_cast<std::size_t>(limit));
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

}  // namespace worlds
