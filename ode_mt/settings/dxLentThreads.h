// The managers of threads that the program lends (dxThreadManagerUser): one for each lender, whoever uses it. Several worlds may share an
// implementation, and the process may have it too; two managers would have two calls waiting in its pool.
//
// In a forked child the threads are gone: whoever was lent them works alone there, until the child lends some itself.
//
// A run looks its manager up in a list that is as short as there are lenders. Any thread may call.
#pragma once

#include <memory>

#include "threading/managers/dxThreadManagerUser.h"

namespace dxLentThreads {

// The program lends these threads now.
void lend(const dxThreadLender &lender);

// Throws std::bad_alloc.
std::shared_ptr<dxThreadManagerUser> managerOf(const dxThreadLender &lender);

// The threads are to leave the library: waits for them, unless a run of another thread goes on, which then waits at its end. Who still uses
// the lender borrows them anew.
void giveBack(const dxThreadLender &lender);

}  // namespace dxLentThreads
