#include "contact_probe.h"

#include <algorithm>
#include <cstring>

namespace exactness {

namespace {

constexpr int maxAsked = 0xffff;  // as many as dCollide's flags can say
constexpr unsigned char fresh = 0xa5;
constexpr int border = 64;          // bytes behind the buffer
constexpr int slotsLookedAt = 256;  // no call returns as many contacts

}  // namespace

int ContactProbe::collide(dGeomID o1, dGeomID o2, int flags, int skip) {
    prepare(flags & maxAsked, skip);
    m_count = dCollide(o1, o2, flags, reinterpret_cast<dContactGeom *>(m_bytes.data()), skip);
    return m_count;
}

void ContactProbe::prepare(int asked, int skip) {
    m_asked = asked;
    m_skip = skip;
    const std::size_t size = static_cast<std::size_t>(asked) * skip + border;
    if (m_bytes.size() < size) m_bytes.resize(size);
    std::fill_n(m_bytes.begin(), static_cast<std::size_t>(checkedSlots()) * skip, fresh);
    std::fill_n(m_bytes.begin() + (size - border), border, fresh);
}

int ContactProbe::checkedSlots() const { return std::min(m_asked, slotsLookedAt); }

const dContactGeom &ContactProbe::contact(int number) const {
    return *reinterpret_cast<const dContactGeom *>(m_bytes.data() +
                                                   static_cast<std::size_t>(number) * m_skip);
}

bool ContactProbe::wroteBeside() const {
    const auto isFresh = [](unsigned char byte) { return byte == fresh; };
    for (int slot = 0; slot < checkedSlots(); ++slot) {
        const auto begin = m_bytes.begin() + static_cast<std::size_t>(slot) * m_skip;
        if (!std::all_of(begin + sizeof(dContactGeom), begin + m_skip, isFresh)) return true;
    }
    const auto end = m_bytes.begin() + static_cast<std::size_t>(m_asked) * m_skip;
    return !std::all_of(end, end + border, isFresh);
}

// CONTACTS_UNIMPORTANT makes some colliders count contacts that they have not filled in: no geoms then.
dContactGeom ContactProbe::contactToTell(int number) const {
    dContactGeom told = contact(number);
    unsigned char unset[sizeof(dGeomID)];
    std::memset(unset, fresh, sizeof(unset));
    if (std::memcmp(&told.g1, unset, sizeof(unset)) == 0) told.g1 = nullptr;
    if (std::memcmp(&told.g2, unset, sizeof(unset)) == 0) told.g2 = nullptr;
    return told;
}

void ContactProbe::tell(scenes::Observer *observer) const {
    if (observer == nullptr) return;
    observer->note(wroteBeside() ? "contacts, and bytes beside them" : "contacts", m_count);
    for (int i = 0; i < m_count; ++i) {
        dContact told{};
        told.geom = contactToTell(i);
        observer->contact(told);
    }
}

}  // namespace exactness
