// Which thread of ODE_MT's steps each body.
#pragma once

#include <ode/ode.h>

#include <vector>

namespace record {

class BodyWorkers {
public:
    // From now on steps note it. Throws std::runtime_error if the library cannot.
    BodyWorkers();

    // In the last step: 0: the thread that called it; n: worker n; -1: none, the body slept.
    std::vector<int> of(const std::vector<dBodyID> &bodies) const;

private:
    decltype(&dODE_MT_GetBodyWorker) m_get;
};

}  // namespace record
