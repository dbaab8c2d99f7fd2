// Plays a script on both libraries and says whether they agree.
#pragma once

#include "call.h"
#include "playing_process.h"

#include <memory>
#include <string>

namespace fuzz {

struct Libraries {
    std::string player;  // odemt_fuzz_player
    std::string debian, ours;  // folders
    // The solver fast on ODE_MT is compared with its own run on one thread without vectors, which then stands for Debian's library.
    bool isFast = false;
};

enum class Verdict {
    same,
    different,
    // Scripts without a verdict about ODE_MT:
    upstreamCrashed,     // by a fault of its own
    upstreamTooSlow,
    memoryOver,          // steps that were left by jumps have taken all that a script may take, on one of the two
    upstreamUndefined,   // its result depends on unwritten memory
    signOfNaN,           // messages of the LCP solver differ in their number, or are heard on one side alone
};
const char *nameOf(Verdict verdict);

class Comparison {
public:
    explicit Comparison(const Libraries &libraries);
    // `ours` plays on ODE_MT instead of processes.
    Comparison(const Libraries &libraries, std::shared_ptr<Playing> ours);

    // How many times the time that a script may take it may take on ours, when it is played again: algorithms that share always,
    // whatever it costs, may have to wait for other programs.
    void setPatience(unsigned times) { m_patience = times; }

    Verdict compare(const RequestHeader &request, const std::vector<std::uint8_t> &script);
    Verdict compare(RequestHeader request, const Script &script);

    // Returns whether, for the last script that differs, upstream's result depends on unwritten memory, which
    // the patterns that compare() tries have not shown. Takes seconds.
    bool isUpstreamUnset(const RequestHeader &request) const;

    const Outcome &reference() const { return m_reference; }
    const Outcome &ours() const { return m_ours; }
    // Both as text, and the first lines that differ.
    std::string difference(RequestHeader request, const Script &script);
    std::string difference(RequestHeader request, const std::vector<std::uint8_t> &script);
    std::string lastDifference() const;  // of the scripts that were compared last

private:
    static bool hasFailed(const Outcome &outcome);
    static bool hasFailedInStep(const Outcome &outcome);
    static bool areSame(const Outcome &a, const Outcome &b);
    bool isCertain(RequestHeader request, const std::vector<std::uint8_t> &script);
    Outcome onDebian(const RequestHeader &request, const std::vector<std::uint8_t> &script);

    Comparison(const Libraries &libraries, std::shared_ptr<Playing> ours, std::shared_ptr<Playing> oursDisturbed);

    const Libraries m_libraries;
    const std::shared_ptr<Playing> m_onDebian;
    const std::shared_ptr<Playing> m_onReference, m_onReferencePatterned;  // what ours are compared with: Debian's, or fast on one thread
    const std::shared_ptr<Playing> m_onOurs, m_onOursDisturbed;
    Outcome m_reference, m_ours;
    unsigned m_patience = 24;
};

}  // namespace fuzz
