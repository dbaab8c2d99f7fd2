// What callbacks that run at once get from the library is what they get one at a time: answers to bad arguments, and what they
// read from a joint that they have just made.
//
// Covers api/objects.cpp, dxSpaceCollision.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>

#include "support/child_run.h"
#include "OdeSession.h"
#include "SphereRows.h"

namespace {

struct BadCall {
    const char *name;
    void (*make)(dWorldID world, dGeomID o1, dGeomID o2);
};

void PrintTo(const BadCall &call, std::ostream *out) { *out << call.name; }

dContactGeom g_contactGeom;
dContact g_contact;

const BadCall kBadCalls[] = {
    {"NoFirstGeom", [](dWorldID, dGeomID, dGeomID o2) { dCollide(nullptr, o2, 1, &g_contactGeom, sizeof g_contactGeom); }},
    {"NoSecondGeom", [](dWorldID, dGeomID o1, dGeomID) { dCollide(o1, nullptr, 1, &g_contactGeom, sizeof g_contactGeom); }},
    {"NoGeoms", [](dWorldID, dGeomID, dGeomID) { dCollide(nullptr, nullptr, 1, &g_contactGeom, sizeof g_contactGeom); }},
    {"NoPlaceForContacts", [](dWorldID, dGeomID o1, dGeomID o2) { dCollide(o1, o2, 1, nullptr, sizeof g_contactGeom); }},
    {"NoWorld", [](dWorldID, dGeomID, dGeomID) { dJointCreateContact(nullptr, nullptr, &g_contact); }},
    {"NoContact", [](dWorldID world, dGeomID, dGeomID) { dJointCreateContact(world, nullptr, nullptr); }},
    {"NoJoint", [](dWorldID, dGeomID o1, dGeomID o2) { dJointAttach(nullptr, dGeomGetBody(o1), dGeomGetBody(o2)); }},
};

// One callback of all makes it.
struct Caller {
    const BadCall &call;
    dWorldID world;
    std::atomic<bool> isMade{false};

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        Caller &caller = *static_cast<Caller *>(data);
        if (!caller.isMade.exchange(true)) caller.call.make(caller.world, o1, o2);
    }
};

class BadArguments : public testing::TestWithParam<BadCall> {
protected:
    static support::Ending endWith(const char *policy) {
        return support::runInChild([policy] {
            const OdeSession session(3, "lcp");
            dODE_MT_SetCallbackPolicy(policy);
            SphereRows rows(dHashSpaceCreate(nullptr));
            Caller caller{GetParam(), rows.world()};
            dSpaceCollide(rows.space(), &caller, Caller::meet);
        });
    }
};

TEST_P(BadArguments, AreAnsweredAsOneAtATime) {
    const support::Ending expected = endWith("serial");
    EXPECT_NE(expected.errors, "");
    for (const char *policy : {"concurrent", "independent"}) {
        const support::Ending end = endWith(policy);
        EXPECT_EQ(end.errors, expected.errors) << policy;
        EXPECT_EQ(end.status, expected.status) << policy;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, BadArguments, testing::ValuesIn(kBadCalls), [](const auto &info) { return info.param.name; });

// Joints with two bodies, with one in the first place and in the second, and with other ones afterwards.
struct Reader {
    dWorldID world;
    dJointGroupID group;
    std::atomic<int> joints{0}, wrong{0};

    void expect(dJointID joint, dBodyID body1, dBodyID body2) {
        if (dJointGetBody(joint, 0) != body1 || dJointGetBody(joint, 1) != body2) ++wrong;
    }

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        Reader &reader = *static_cast<Reader *>(data);
        const dBodyID body1 = dGeomGetBody(o1), body2 = dGeomGetBody(o2);
        dContact contact{};
        if (dCollide(o1, o2, 1, &contact.geom, sizeof contact) == 0) return;
        contact.surface.mu = 1;
        const dJointID joint = dJointCreateContact(reader.world, reader.group, &contact);
        ++reader.joints;
        if (dJointGetType(joint) != dJointTypeContact || dJointIsEnabled(joint) == 0) ++reader.wrong;
        reader.expect(joint, nullptr, nullptr);
        dJointAttach(joint, nullptr, body2);
        reader.expect(joint, nullptr, body2);
        dJointAttach(joint, body1, nullptr);
        reader.expect(joint, body1, nullptr);
        dJointAttach(joint, body1, body2);
        reader.expect(joint, body1, body2);
    }
};

TEST(ConcurrentCallbacks, ReadWhatTheyHaveAttached) {
    const OdeSession session(3, "lcp");
    for (const char *policy : {"serial", "concurrent", "independent"}) {
        dODE_MT_SetCallbackPolicy(policy);
        SphereRows rows(dHashSpaceCreate(nullptr));
        Reader reader{rows.world(), dJointGroupCreate(0)};
        dSpaceCollide(rows.space(), &reader, Reader::meet);
        EXPECT_EQ(reader.joints, SphereRows::kPairs) << policy;
        EXPECT_EQ(reader.wrong, 0) << policy;
        dJointGroupDestroy(reader.group);
    }
    dODE_MT_SetCallbackPolicy("serial");
}

}  // namespace
