#include "forked_play.h"

#include "draw.h"
#include "only_ours.h"
#include "player.h"

#include "engine_statistics.h"
#include "instruction_set.h"

#include <ode/ode.h>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <utility>

namespace fuzz {

namespace {

constexpr std::size_t kMaxText = 64u << 20;
constexpr rlim_t kMaxMemory = rlim_t{4} << 30;  // bytes that a script may take: height fields under huge boxes ask for more

void set(const RequestHeader &request) {
    callIfThere("dToggleODE_MT", static_cast<int>(request.threads));
    callIfThere("dODE_MT_SetThreadManager", kManagers[request.manager % 2]);
    callIfThere("dODE_MT_SetAlgorithm", kAlgorithms[request.algorithm % 8]);
    callIfThere("dODE_MT_SetGridCells", request.cells == 0 ? 0 : 5 + request.cells % 16);
    const std::vector<std::string> sets = exactness::instructionSets();
    if (playedAs.isSerial && !sets.empty()) return exactness::forceInstructionSet(sets.back());
    if (request.instructionSet != 0 && !sets.empty()) exactness::forceInstructionSet(sets[request.instructionSet % sets.size()]);
}

}  // namespace

// What a playing process leaves behind, however it ends.
struct ForkedPlay::Remains {
    std::uint64_t hash;
    std::uint32_t calls, workers, directIslands;
    std::uint32_t length;
    char text[kMaxText];

    void play(const RequestHeader &request, const std::vector<std::uint8_t> &script) noexcept;
};

// An exception ends the child, which is one of the endings that are compared.
void ForkedPlay::Remains::play(const RequestHeader &request, const std::vector<std::uint8_t> &script) noexcept {
    alarm(request.wallSeconds);
    const rlimit time{request.seconds, request.seconds + 1u};
    setrlimit(RLIMIT_CPU, &time);
    const rlimit memory{kMaxMemory, kMaxMemory};
    setrlimit(RLIMIT_AS, &memory);
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    set(request);
    Player::Options options;
    options.jumps = request.jumps != 0;
    options.messages = request.messages != 0;
    options.tells = request.tells != 0;
    options.fillsStack = request.fillsStack;
    options.maxCalls = request.maxCalls;
    Player *player = nullptr;
    const auto writer = [&](const std::string &written) {
        if (player != nullptr) {
            hash = player->hash();
            calls = static_cast<std::uint32_t>(player->calls());
        }
        if (length + written.size() > kMaxText) return;
        std::memcpy(text + length, written.data(), written.size());
        length += static_cast<std::uint32_t>(written.size());
    };
    Player playing(options, writer);
    player = &playing;
    if (request.isText != 0) {
        playing.play(scriptOf(std::string(script.begin(), script.end())));
    } else {
        Draw draw(script.data(), script.size());
        playing.play(draw);
    }
    playing.finish();
    hash = playing.hash();
    workers = exactness::runningEngine().maxWorkers;
    if (const auto count = functionOfOurs<unsigned>("dODE_MT_GetDirectIslands")) directIslands = count();
}

ForkedPlay::ForkedPlay(AtBirth atBirth, AfterDeath afterDeath)
    : m_atBirth(std::move(atBirth)), m_afterDeath(std::move(afterDeath)) {
    void *const shared = mmap(nullptr, sizeof(Remains), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory to share with playing processes");
    m_remains = static_cast<Remains *>(shared);
    functions();  // once, not in each child
}

ForkedPlay::~ForkedPlay() { munmap(m_remains, sizeof *m_remains); }

void ForkedPlay::ask(RequestHeader request, const std::vector<std::uint8_t> &script) {
    m_remains->hash = 0;
    m_remains->calls = m_remains->workers = m_remains->directIslands = m_remains->length = 0;
    m_errors.write("");
    m_child = fork();
    if (m_child < 0) throw std::runtime_error("no process to play in");
    if (m_child > 0) return;
    if (m_atBirth) m_atBirth(request);
    dup2(m_errors.descriptor(), STDERR_FILENO);
    dup2(m_errors.descriptor(), STDOUT_FILENO);
    m_remains->play(request, script);
    _exit(0);
}

Outcome ForkedPlay::answer() {
    Outcome outcome;
    const int status = support::waitFor(m_child);
    if (m_afterDeath) m_afterDeath();
    outcome.errors = errors();
    outcome.text.assign(m_remains->text, m_remains->length);
    outcome.header = {status,
                      m_remains->calls,
                      m_remains->hash,
                      m_remains->workers,
                      m_remains->directIslands,
                      static_cast<std::uint32_t>(outcome.errors.size()),
                      m_remains->length};
    return outcome;
}

// The place in the source is not compared (contract C8).
std::string ForkedPlay::errors() const {
    const std::string text = m_errors.text();
    if (text.find('[') == std::string::npos) return text;
    static const std::regex place("\\[[^\\]]*:[0-9]+\\]");
    return std::regex_replace(text, place, "[file:line]");
}

}  // namespace fuzz
