// The contact joints of a frame with the forces in them: dJointCreateContact is wrapped by the linker (CMakeLists.txt), so that scenes
// need not know. Each joint is given a feedback of ours; results do not change by it. Requires near-callbacks on one thread.
#pragma once

#include "record/recording.h"

#include <ode/ode.h>

#include <deque>
#include <vector>

namespace record {

class ContactLog {
public:
    ContactLog();  // from now on joints are recorded; only one log at a time
    ~ContactLog();
    ContactLog(const ContactLog &) = delete;
    ContactLog &operator=(const ContactLog &) = delete;

    void clear() { m_entries.clear(); }
    void add(const dContact &contact, dJointID joint);

    // The contacts since `clear`, as they are after the step. `geoms`: those that a recording knows, by place.
    std::vector<Contact> contacts(const std::vector<dGeomID> &geoms) const;

private:
    struct Entry {
        dContactGeom geom;
        dJointFeedback feedback;
    };

    std::deque<Entry> m_entries;  // whose feedbacks stay where they are
};

}  // namespace record
