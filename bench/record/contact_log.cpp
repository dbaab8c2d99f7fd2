#include "record/contact_log.h"

#include <unordered_map>

namespace {

record::ContactLog *current = nullptr;

}  // namespace

extern "C" {

dJointID __real_dJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact);

dJointID __wrap_dJointCreateContact(dWorldID world, dJointGroupID group, const dContact *contact) {
    const dJointID joint = __real_dJointCreateContact(world, group, contact);
    if (current) current->add(*contact, joint);
    return joint;
}
}

namespace record {

ContactLog::ContactLog() { current = this; }
ContactLog::~ContactLog() { current = nullptr; }

void ContactLog::add(const dContact &contact, dJointID joint) {
    m_entries.push_back({contact.geom, {}});
    dJointSetFeedback(joint, &m_entries.back().feedback);
}

std::vector<Contact> ContactLog::contacts(const std::vector<dGeomID> &geoms) const {
    std::unordered_map<dGeomID, int> places;
    for (std::size_t i = 0; i < geoms.size(); ++i) places.emplace(geoms[i], static_cast<int>(i));
    const auto placeOf = [&](dGeomID geom) {
        const auto found = places.find(geom);
        return found == places.end() ? Contact::kUnknown : found->second;
    };
    std::vector<Contact> contacts;
    for (const Entry &entry : m_entries) {
        const dContactGeom &geom = entry.geom;
        // The joint's first body is that of the first geom that has one.
        const double sign = dGeomGetBody(geom.g1) ? 1 : -1;
        Contact contact{placeOf(geom.g1), placeOf(geom.g2), {}, {}, static_cast<double>(geom.depth), {}};
        for (std::size_t i = 0; i < 3; ++i) {
            contact.position[i] = static_cast<double>(geom.pos[i]);
            contact.normal[i] = static_cast<double>(geom.normal[i]);
            contact.force[i] = sign * static_cast<double>(entry.feedback.f1[i]);
        }
        contacts.push_back(contact);
    }
    return contacts;
}

}  // namespace record
