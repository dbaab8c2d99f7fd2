#include "dynamics/step/islands/dxBodyWorkers.h"

namespace {

constexpr int kTagOfCaller = -1000;  // of worker n: n below; other tags are larger

}  // namespace

std::atomic<bool> dxBodyWorkers::s_isNoted{false};

int dxBodyWorkers::of(const dxBody &body) { return body.tag <= kTagOfCaller ? kTagOfCaller - body.tag : kNone; }

void dxBodyWorkers::tagBodies(const dxIsland &island, unsigned worker) {
    for (unsigned i = 0; i < island.bodyCount; ++i) island.bodies[i]->tag = kTagOfCaller - static_cast<int>(worker);
}
