// Rules by which problems are given to workers: dxRemoteScheduler keeps them, and bench/scale/ predicts from them how long a step takes.
//
// Units: costs in ns of work in this process, times in ns of one clock.
#pragma once

#include <algorithm>
#include <cstddef>

// A thread that has other work looks for messages no more often, as each look costs it system calls (dxGuards.h), but for when a problem is new and a
// worker has nothing to do.
constexpr double kRemoteBetweenLooksNs = 60e3;

// Problems go to the link with the least to do. Of elements with a dxRemoteLink `link`; null: none is free.
template <class Links>
auto dxFindFreestLink(Links &links, double now) -> decltype(links.data()) {
    decltype(links.data()) freest = nullptr;
    for (auto &one : links)
        if (one.link.isFree(now) && (freest == nullptr || one.link.inFlight().size() < freest->link.inFlight().size())) freest = &one;
    return freest;
}

template <class Links>
bool dxIsAnyIdle(const Links &links, double now) {
    return std::any_of(links.begin(), links.end(), [now](const auto &one) { return one.link.isIdle(now); });
}

// Problems go out together up to so much work: small ones share the price of a message. Towards the end of a step messages become small, so that
// all workers end at the same time. One problem goes out whatever it costs.
inline double dxMaxMessageCost(double queuedCost, std::size_t links) {
    constexpr double kMaxNs = 400e3;
    return std::min(kMaxNs, queuedCost / (2.0 * static_cast<double>(links)));
}

// A process that has nothing left to do reclaims problems if it needs less than this part of the time until they are expected.
inline bool dxIsSoonerHere(double cost, double expected, double now) {
    constexpr double kSooner = 0.8;
    return cost <= kSooner * (expected - now);
}
