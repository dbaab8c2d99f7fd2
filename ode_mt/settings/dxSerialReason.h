// The text for each dODE_MT_Reason: why a step or collision ran on one thread. bench/top uses it, too.
//
// Threading: any thread.
#pragma once

#include <array>
#include <cstddef>

#include <ode/ode_MT.h>

// In the order of the enumeration.
inline constexpr std::array<const char *, 22> kReasonTexts = {
    "several threads took part",
    "there was nothing to do",
    "the number of threads is 0 or 1",
    "the algorithm is \"serial\"",
    "the process may use one core",
    "the world is limited to one thread",
    "the world's threading implementation has one thread",
    "floating-point errors are trapped",
    "there is one island, too small for several threads",
    "the number of iterations is above 100000",
    "several threads are predicted to take longer",
    "one island is nearly all there is, and several threads take longer for it",
    "a body with a moved-callback is in one of the first islands",
    "the calling thread was done before another one came",
    "there was no memory for more",
    "the space has too few geoms",
    "several threads have not been measured to be faster",
    "it was called by a near-callback of another collision",
    "the callback policy is \"serial\"",
    "few pairs, or most of them share bodies",
    "joints of one of the first islands share a feedback structure with those of another",
    "it was stepped beside other worlds, as a whole by one thread",
};
static_assert(kReasonTexts.size() == dODE_MT_REASON_WORLDS + 1, "a text for each reason");

// Returns a clause; for numbers that are no reason, too.
inline const char *dxTextOfReason(int reason) {
    const auto index = static_cast<std::size_t>(reason);
    return index < kReasonTexts.size() ? kReasonTexts[index] : "unknown reason";
}
