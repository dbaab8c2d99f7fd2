#include "threading/pool/dxThreadLender.h"

#include <algorithm>

#include "threading/pool/dxThreadCreation.h"

unsigned dxThreadLender::threads() const {
    return executor != nullptr ? dxMaxWorkers : functions->retrieve_thread_count(implementation);
}

void dxThreadLender::prepare() const {
    if (executor == nullptr) functions->preallocate_resources_for_calls(implementation, std::max(threads(), 1u));
}

void dxThreadLender::post(dThreadedCallFunction *call, Work work, void *data) const {
    if (executor != nullptr)
        executor(context, work, data);
    else
        functions->post_call(implementation, nullptr, nullptr, 0, nullptr, nullptr, call, data, 0, "ODE_MT worker");
}
