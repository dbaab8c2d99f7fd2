// A library that owns a thread manager the way libode does: in a static object that ends it when the
// library is unloaded.
#include "threading/managers/dxThreadManagerFactory.h"

extern "C" __attribute__((visibility("default"))) unsigned useThreadManager(const char *name,
                                                                            unsigned workers) {
    static const std::unique_ptr<dxThreadManager> manager = dxThreadManagerFactory::create(name);
    manager->resize(workers);
    unsigned sum = 0;
    unsigned partial[1024] = {};
    manager->run(
        1000, workers,
        [](void *sums, unsigned block, unsigned worker) { static_cast<unsigned *>(sums)[worker] += block; },
        partial);
    for (const unsigned part : partial) sum += part;
    return sum;
}
