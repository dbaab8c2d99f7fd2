// One dxThreadManagerUser per threading implementation, made when a world that has it is stepped.
//
// A manager must outlast single steps: its borrowed threads go on looking for work for a moment. And
// there must be only one for an implementation. Any thread may call.
#pragma once

#include <memory>

#include "dxThreadManagerUser.h"

namespace dxUserThreadManagers {

std::shared_ptr<dxThreadManager> find(const dThreadingFunctionsInfo *functions,
                                      dThreadingImplementationID implementation);

// Destroys all that no run is using (dCloseODE).
void clear();

}  // namespace dxUserThreadManagers
