// A crowd of small geoms in one space: spheres, boxes, capsules and cylinders alternately, every third one with
// a body, all weightless. The bodies belong to families; only bodies of one family push one another, so that
// there are many islands, but the observer gets all pairs.
#pragma once

#include "dice.h"
#include "scenario_scene.h"

namespace exactness {

class Crowd : public ScenarioScene {
protected:
    Crowd(Stepper stepper, SpaceKind kind, unsigned seed = 1);

    dGeomID addMember(Vector3 place, dReal size);
    dGeomID addMemberWithoutBody(Vector3 place, dReal size);
    void addMembers(int count, dReal halfEdge, dReal size);  // around the origin

    // Members that may be seen near others and are never asked for contacts.
    void keepFromContacts(dGeomID geom);

    // Until the next call only every nth body moves, and the geoms without bodies with the same numbers are
    // moved now; 0: none.
    void moveEvery(int nth);

    // Moves all members, none, or a few, alternately.
    void alternate();

    void nudge(dGeomID geom);

    void onNearPair(dGeomID o1, dGeomID o2) override;

    Dice m_dice;

private:
    dGeomID createByTurns(dReal size);

    int m_turns = 0;
};

}  // namespace exactness
