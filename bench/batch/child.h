// Processes that make worlds for this one.
#pragma once

#include <ode/ode.h>
#include <sys/types.h>

namespace batch {

// fork(), and the child ends with this process. Requires that no threads are running.
pid_t forkChild();

// In a child: ODE is ready, its messages are ignored, its errors go to the handler, which does not return.
void initialiseOde(dMessageFunction *endByError);

}  // namespace batch
