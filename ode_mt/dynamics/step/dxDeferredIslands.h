// The islands of one step as units of a deferred run (dxDeferredRun): workers step them, in arenas of their own. Where the user has handlers, the
// state that is needed to undo a step is saved.
//
// Threading: step(), save(), arenaOf() and run() on workers, for different islands; everything else on the thread that called the step.
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/dxStepRecords.h"

class dxDeferredIslands {
public:
    // The records are those of dxPrepareIslands; before a step the caller, as worker 0, has put its arena there.
    dxDeferredIslands(const dxStepCall &call, dxStepRecords &records) : m_call(call), m_records(records) {}

    const dxStepCall &call() const { return m_call; }
    dxStepRecords &records() const { return m_records; }

    // Steps an island. Without memory the island is unchanged (stepRest()).
    void step(unsigned index, unsigned worker);

    // The parts of step(), for an island that is stepped in two parts. save() comes first. It returns false if there is no memory; the run is
    // then interrupted there.
    bool save(unsigned index, unsigned worker);
    template <class Work>
    void run(unsigned index, unsigned worker, const Work &work) {
        m_records.run.run(index, worker, work);
    }

    // Returns null if there is no memory.
    dxWorldProcessMemArena *arenaOf(unsigned worker);

    // Returns false if the island would be undone.
    bool isNeeded(unsigned index) const { return m_records.run.isNeeded(index); }

    // Steps the islands that no worker has stepped, before the first one that has to be stepped in order.
    void stepRest();

    // Makes the steps of the islands visible in upstream's order, up to the first one for which that is not possible: it has to be stepped in order,
    // was interrupted, or has a geom in a space that is being collided. Undoes those after it. Returns that one. The last call.
    unsigned commit();

private:
    unsigned findEnd() const;
    void takeBack(unsigned begin);
    void giveArenasBack();

    const dxStepCall &m_call;
    dxStepRecords &m_records;
};
