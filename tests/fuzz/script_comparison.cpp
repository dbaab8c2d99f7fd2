#include "script_comparison.h"

#include "input.h"
#include "unset_memory.h"
#include "support/process.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

namespace fuzz {

namespace {

// Messages of libode8 after which it uses unwritten numbers (docs/testing.md).
constexpr const char *kUndefined[] = {
    "zero length vector in dRFrom2Axes",  // the matrix on the stack is left as it is
};

bool isUndefined(const Outcome &outcome) {
    return std::any_of(std::begin(kUndefined), std::end(kUndefined), [&](const char *words) {
        return outcome.errors.find(words) != std::string::npos || outcome.text.find(words) != std::string::npos;
    });
}

// Whether the LCP solver gives rows up, how many, and the numbers that it then says, hang on the signs of NaNs where one of them
// is a step of infinite length (docs/exactness.md).
std::string withoutNumbers(const std::string &text) {
    static const std::regex number("\\(s=[^)]*\\)");
    return std::regex_replace(text, number, "(s)");
}
std::string withoutGivenUpRows(const std::string &text) {
    static const std::regex message("\n?[^\n]*LCP internal error, s <= 0 \\(s=[^)]*\\)\n?");
    return std::regex_replace(text, message, "");
}
bool saysEndlessPush(const std::string &text) {
    static const std::regex message("LCP internal error, s <= 0 \\(s=-?(inf|nan)\\)");
    return std::regex_search(text, message);
}

bool differInSignsOfNaNs(const std::string &a, const std::string &b) {
    if (withoutNumbers(a) == withoutNumbers(b)) return true;
    return (saysEndlessPush(a) || saysEndlessPush(b)) && withoutGivenUpRows(a) == withoutGivenUpRows(b);
}

// Where two texts begin to differ.
struct Fork {
    std::string call;              // the last one before it
    std::optional<std::string> a, b;  // lines; none: the text has ended
};

Fork forkOf(const std::string &textA, const std::string &textB) {
    std::istringstream streamA(textA), streamB(textB);
    Fork fork;
    for (std::string a, b;;) {
        fork.a = std::getline(streamA, a) ? std::optional(a) : std::nullopt;
        fork.b = std::getline(streamB, b) ? std::optional(b) : std::nullopt;
        if (!fork.a || fork.a != fork.b) return fork;
        if (a.compare(0, 4, "    ") != 0) fork.call = a;
    }
}

// A handler of the script's heard such a message on one of the two alone, before anything else differed, and made calls then.
bool isHeardOnOneSide(const std::string &textA, const std::string &textB) {
    const Fork fork = forkOf(textA, textB);
    return saysEndlessPush(fork.a.value_or("")) || saysEndlessPush(fork.b.value_or(""));
}

}  // namespace

const char *nameOf(Verdict verdict) {
    static constexpr const char *names[] = {
        "same", "different", "upstream crashes", "upstream is too slow", "memory is over", "upstream is undefined", "sign of a NaN in a message"};
    return names[static_cast<int>(verdict)];
}

namespace {

// Blocks of a thread's cache would not get the pattern.
const support::Environment kPatterned{{"MALLOC_PERTURB_", "165"}, {"GLIBC_TUNABLES", "glibc.malloc.tcache_count=0"}};
// Read when the library is loaded.
const support::Environment kDisturbed{{"ODE_MT_PERTURB", "1"}};

std::shared_ptr<Playing> processOfFast(const Libraries &libraries, const char *option, support::Environment environment) {
    environment["ODE_MT_SOLVER"] = "fast";
    return std::make_shared<PlayingProcess>(std::vector<std::string>{libraries.player, option}, libraries.ours, std::move(environment));
}

std::shared_ptr<Playing> processOfOurs(const Libraries &libraries, const support::Environment &environment) {
    if (libraries.isFast) return processOfFast(libraries, "--fast", environment);
    return std::make_shared<PlayingProcess>(std::vector<std::string>{libraries.player}, libraries.ours, environment);
}

// Draws what that of ours draws.
std::shared_ptr<Playing> processOfDebian(const Libraries &libraries, const support::Environment &environment) {
    std::vector<std::string> command{libraries.player};
    if (libraries.isFast) command.push_back("--fast");
    return std::make_shared<PlayingProcess>(command, libraries.debian, environment);
}

}  // namespace

Comparison::Comparison(const Libraries &libraries)
    : Comparison(libraries, processOfOurs(libraries, {}), processOfOurs(libraries, kDisturbed)) {}

Comparison::Comparison(const Libraries &libraries, std::shared_ptr<Playing> ours) : Comparison(libraries, ours, ours) {}

Comparison::Comparison(const Libraries &libraries, std::shared_ptr<Playing> ours, std::shared_ptr<Playing> oursDisturbed)
    : m_libraries(libraries),
      m_onDebian(processOfDebian(libraries, {})),
      m_onReference(libraries.isFast ? processOfFast(libraries, "--fast-serial", {}) : m_onDebian),
      m_onReferencePatterned(libraries.isFast ? processOfFast(libraries, "--fast-serial", kPatterned) : processOfDebian(libraries, kPatterned)),
      m_onOurs(std::move(ours)),
      m_onOursDisturbed(std::move(oursDisturbed)) {}

bool Comparison::hasFailed(const Outcome &outcome) { return !outcome.endedInTime() || outcome.crashed(); }

// Other calls are upstream's with either solver, but may come to be made with one alone.
bool Comparison::hasFailedInStep(const Outcome &outcome) {
    if (!hasFailed(outcome)) return false;
    std::istringstream lines(outcome.text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.compare(0, 4, "    ") != 0) last = line;
    return last.find("Step") != std::string::npos;
}

bool Comparison::areSame(const Outcome &a, const Outcome &b) {
    return a.header.ending == b.header.ending && a.header.hash == b.header.hash && a.errors == b.errors && a.text == b.text;
}

Verdict Comparison::compare(const RequestHeader &request, const std::vector<std::uint8_t> &script) {
    Playing &onOurs = request.disturbs != 0 ? *m_onOursDisturbed : *m_onOurs;
    m_onReference->ask(request, script);
    onOurs.ask(request, script);
    m_reference = m_onReference->answer();
    m_ours = onOurs.answer();
    RequestHeader patient = request;
    patient.seconds = static_cast<std::uint16_t>(m_patience * request.seconds);
    if (m_libraries.isFast && !m_reference.endedInTime()) {
        m_onReference->ask(patient, script);
        m_reference = m_onReference->answer();
    }
    if (m_libraries.isFast && hasFailedInStep(m_reference) && !hasFailed(onDebian(request, script))) return Verdict::different;
    if (!m_reference.endedInTime()) return Verdict::upstreamTooSlow;
    if (!m_ours.endedInTime()) {
        onOurs.ask(patient, script);
        m_ours = onOurs.answer();
    }
    if (m_reference.crashed()) return Verdict::upstreamCrashed;
    const auto hadNoMemory = [](const Outcome &outcome) { return outcome.text.find(kMemoryIsOver) != std::string::npos; };
    if (hadNoMemory(m_reference) || hadNoMemory(m_ours)) return Verdict::memoryOver;
    if (areSame(m_reference, m_ours)) return Verdict::same;
    if (isUndefined(m_reference)) return Verdict::upstreamUndefined;
    if (m_reference.header.hash == m_ours.header.hash && m_reference.header.ending == m_ours.header.ending &&
        differInSignsOfNaNs(m_reference.text, m_ours.text) && differInSignsOfNaNs(m_reference.errors, m_ours.errors))
        return Verdict::signOfNaN;
    if (isHeardOnOneSide(m_reference.text, m_ours.text)) return Verdict::signOfNaN;
    return isCertain(patient, script) ? Verdict::different : Verdict::upstreamUndefined;
}

Outcome Comparison::onDebian(const RequestHeader &request, const std::vector<std::uint8_t> &script) {
    m_onDebian->ask(request, script);
    return m_onDebian->answer();
}

// The reference gives the same whatever memory held before.
bool Comparison::isCertain(RequestHeader request, const std::vector<std::uint8_t> &script) {
    constexpr std::uint8_t bytes[] = {0x7f, 0x01, 0xfe};  // of doubles that are huge, tiny, and huge below zero
    return std::all_of(std::begin(bytes), std::end(bytes), [&](std::uint8_t byte) {
        request.fillsStack = byte;
        m_onReferencePatterned->ask(request, script);
        return areSame(m_reference, m_onReferencePatterned->answer());
    });
}

bool Comparison::isUpstreamUnset(const RequestHeader &request) const {
    return readsUnsetMemory(m_libraries.player, m_libraries.debian, settingOf(request) + m_reference.text);
}

Verdict Comparison::compare(RequestHeader request, const Script &script) {
    request.isText = 1;
    const std::string text = textOf(script);
    return compare(request, std::vector<std::uint8_t>(text.begin(), text.end()));
}

std::string Comparison::difference(RequestHeader request, const Script &script) {
    request.isText = 1;
    const std::string text = textOf(script);
    return difference(request, std::vector<std::uint8_t>(text.begin(), text.end()));
}

std::string Comparison::difference(RequestHeader request, const std::vector<std::uint8_t> &script) {
    request.tells = 1;
    compare(request, script);
    return lastDifference();
}

std::string Comparison::lastDifference() const {
    const Fork fork = forkOf(m_reference.text, m_ours.text);
    const std::string reference = m_libraries.isFast ? "one thread" : "libode8";
    std::string told =
        "  after " + fork.call + "\n  " + reference + ' ' + fork.a.value_or("(ends)") + "\n  ODE_MT  " + fork.b.value_or("(ends)") + '\n';
    if (m_reference.header.hash != m_ours.header.hash) told += "  what they saw differs\n";
    if (m_reference.header.ending != m_ours.header.ending)
        told += "  " + reference + " ends with " + m_reference.ending() + ", ODE_MT with " + m_ours.ending() + '\n';
    if (m_reference.errors != m_ours.errors) told += "  " + reference + " says:\n" + m_reference.errors + "  ODE_MT says:\n" + m_ours.errors;
    return told;
}

}  // namespace fuzz
