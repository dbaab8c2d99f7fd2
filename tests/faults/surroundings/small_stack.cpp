#include <pthread.h>

#include "surroundings.h"

namespace faults {

std::uint64_t onSmallStack() {
    constexpr std::size_t kStack = 256 << 10;
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStack);
    std::uint64_t hash = 0;
    pthread_t thread;
    const auto play = [](void *result) -> void * {
        *static_cast<std::uint64_t *>(result) = playFrames();
        return nullptr;
    };
    if (pthread_create(&thread, &attributes, play, &hash) != 0) return 0;
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return hash;
}

}  // namespace faults
