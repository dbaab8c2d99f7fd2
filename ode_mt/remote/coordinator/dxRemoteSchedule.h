// Rules for distributing problems to workers: dxRemoteScheduler follows them, and bench/scale/ predicts from them how long a step takes.
//
// Units: costs in ns of work in this process, times in ns of one clock. Threading: as the owner of the links.
#pragma once

#include <algorithm>
#include <cstddef>

// A thread that has other work looks for messages no more often than this, as each look costs system calls (dxGuards.h), except when there is a new
// problem and an idle worker.
constexpr double kRemoteBetweenLooksNs = 60e3;

// Returns the link with the least to do, which gets the next problem; null: none is free. Elements have a dxRemoteLink `link`.
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

// Returns the maximum cost of the problems of one message: small ones share the cost of a message. Towards the end of a step messages become small,
// so that all workers end at the same time. A message has at least one problem.
inline double dxMaxMessageCost(double queuedCost, std::size_t links) {
    constexpr double kMaxNs = 400e3;
    return std::min(kMaxNs, queuedCost / (2.0 * static_cast<double>(links)));
}

// Returns whether this process, if it has nothing left to do, should reclaim problems: it needs less than this part of the time until their results
// are expected.
inline bool dxIsSoonerHere(double cost, double expected, double now) {
    constexpr double kSooner = 0.8;
    return cost <= kSooner * (expected - now);
}
