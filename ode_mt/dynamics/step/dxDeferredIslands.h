// The islands of one step as units of a deferred run (dxDeferredRun): workers step them, in arenas of their own, and what is needed to take them
// back is saved where the user has handlers.
//
// Threading: step(), save(), arenaOf() and run() on workers, of different islands; all else on the thread that called the step.
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/dxStepRecords.h"

class dxDeferredIslands {
public:
    // The records are those of dxPrepareIslands; before a step the caller, as worker 0, has put its arena there.
    dxDeferredIslands(const dxStepCall &call, dxStepRecords &records) : m_call(call), m_records(records) {}

    const dxStepCall &call() const { return m_call; }
    dxStepRecords &records() const { return m_records; }

    // An island's whole step. One without memory for it stays as it is (stepRest()).
    void step(unsigned index, unsigned worker);

    // The parts of which it consists, for an island that is stepped in several of them. save() comes first; false: there is no memory, and the run is
    // interrupted there.
    bool save(unsigned index, unsigned worker);
    template <class Work>
    void run(unsigned index, unsigned worker, const Work &work) {
        m_records.run.run(index, worker, work);
    }

    // Null: there is no memory.
    dxWorldProcessMemArena *arenaOf(unsigned worker);

    // False: the island would be taken back.
    bool isNeeded(unsigned index) const { return m_records.run.isNeeded(index); }

    // The islands before the first one in order that no worker has stepped.
    void stepRest();

    // Makes the steps of the islands visible in upstream's order, up to the first one that cannot be: one that has to be stepped in order, was
    // interrupted, or has a geom in a space that is being collided. Those after it are taken back. Returns that one.
    // The last call.
    unsigned commit();

private:
    unsigned findEnd() const;
    void takeBack(unsigned begin);
    void giveArenasBack();

    const dxStepCall &m_call;
    dxStepRecords &m_records;
};
