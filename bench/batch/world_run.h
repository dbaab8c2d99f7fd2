// Runs one world of a plan, on the calling thread, from its making to its end.
//
// The random sequence of ODE is set to the run's seed when the world has been made and perturbed, so that a run depends on nothing but the plan:
// no other world may be stepped in the process meanwhile.
#pragma once

#include <ode/ode.h>

#include "batch/plan.h"

namespace batch {

// In a child: ODE is ready, its messages are ignored, its errors go to the handler, which does not return.
void initialiseOde(dMessageFunction *endByError);

// One line of JSON, as it goes from workers to the table (store.h). A run whose world cannot be made has the status "error" and says why.
Json runWorld(const Plan &plan, const Run &run);

// Makes the world of a run, and looks for all that the plan names in it. Throws std::exception with what is wrong.
void tryWorld(const Plan &plan, const Run &run);

// That of a run that has ended before it could answer.
Json failedRun(long number, const std::string &message);

}  // namespace batch
