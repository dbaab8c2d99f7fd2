// The serial strategy: the islands one after the other on the calling thread, in upstream's order.
//
// QuickStep draws random numbers. While one thread alone steps with them they are drawn one by one, as upstream does
// (dxLoneStepper); else those of all islands before the first callback of the user are taken as one block, so that no step of
// another thread draws in between (contract C7).
#pragma once

#include "dynamics/dxStepCall.h"
#include "dynamics/islands/dxIslandTeam.h"

class dxSerialStep {
public:
    explicit dxSerialStep(const dxStepCall &call) : m_call(call) {}

    // Islands of at least so many joints are stepped by the team.
    dxSerialStep(const dxStepCall &call, dxIslandTeam *team, unsigned minTeamJoints)
        : m_call(call), m_team(team), m_minTeamJoints(minTeamJoints) {}

    void run() const;

    // Some islands in a row, whose random numbers are drawn from the scope in force.
    void stepIslands(dxIslandCursor cursor, unsigned count) const;

private:
    void runReserving() const;

    const dxStepCall &m_call;
    dxIslandTeam *const m_team = nullptr;
    const unsigned m_minTeamJoints = 0;
};
