// Calls dCollide with a buffer of its own, and reports the result: how many, each contact, and
// whether anything was written where nothing should be.
#pragma once

#include "scenes/scene.h"

#include <vector>

namespace exactness {

class ContactProbe {
public:
    // Calls dCollide. `skip` is a multiple of 8.
    int collide(dGeomID o1, dGeomID o2, int flags, int skip = sizeof(dContactGeom));

    // The results of the last call.
    const dContactGeom &contact(int number) const;
    int count() const { return m_count; }
    bool wroteBeside() const;  // between contacts, or behind the last one asked for
    void tell(scenes::Observer *observer) const;

private:
    void prepare(int asked, int skip);
    int checkedSlots() const;
    dContactGeom contactToTell(int number) const;

    std::vector<unsigned char> m_bytes;
    int m_asked = 0, m_skip = 0, m_count = 0;
};

}  // namespace exactness
