#include "worlds/judge.h"

#include "driver/message_text.h"
#include "worlds/message_rule.h"

#include <algorithm>
#include <cctype>

namespace fuzz_worlds {

namespace {

std::string megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

std::string namesOf(const std::vector<Spelling> &ways) {
    std::string names;
    for (const Spelling way : ways) names += (names.empty() ? "" : ", ") + std::string(nameOf(way));
    return names;
}

}  // namespace

Loading Judge::load(const WorldCase &world) {
    std::filesystem::remove_all(m_folder);
    writeCase(world, m_folder);
    return fuzz_worlds::load(world, m_folder);
}

Judgement Judge::loads(const WorldCase &world) {
    const Loading loading = load(world);
    switch (loading.result) {
        case Loading::Result::Loaded:
            return {"loaded", whatIsWrongWithMessages(loading, world, m_folder)};
        case Loading::Result::SlowToStep:
            return {"loaded, slow to step", whatIsWrongWithMessages(loading, world, m_folder)};
        case Loading::Result::Refused:
            return {"refused: " + loading.errorKind, whatIsWrongWithMessages(loading, world, m_folder)};
        case Loading::Result::Broken:
            break;
    }
    return {"broken", loading.fault + " (" + megabytes(loading.peakMemory) + " of at most " +
                          megabytes(memoryBound(world)) + ")"};
}

Judgement Judge::refuses(const WorldCase &world, const ForbiddenChange &change) {
    WorldCase changed = world;
    std::string name;
    if (!apply(change, changed, name)) return {"nothing to change", ""};
    const Loading after = load(changed);
    if (after.result == Loading::Result::Refused) {
        if (const std::string wrong = whatIsWrongWithMessages(after, changed, m_folder); !wrong.empty())
            return {"change refused", wrong};
        const std::string named = lastOf(after.placePath);
        // A long name is shown by its begin and end; text in place of a name is reported by its place alone.
        const bool names = named == name || named.find("...") != std::string::npos;
        const Loading before = names ? after : load(world);
        if (names || before.result != Loading::Result::Loaded)
            return {names ? "change refused" : "does not load anyway", ""};
        return {"change refused", "a place not named: " + change.text() + " is refused by: " + after.message};
    }
    if (after.result == Loading::Result::Broken) return {"broken", after.fault};
    return {"change not refused", "loads although: " + change.text()};
}

Judgement Judge::understands(const WorldCase &world, const std::vector<Spelling> &ways, std::uint64_t seed) {
    const Loading before = load(world);
    if (before.result != Loading::Result::Loaded) return {"does not load anyway", before.fault};
    const Loading after = load(respelled(world, ways, seed));
    const std::string spelled = " when spelled with other " + namesOf(ways);
    if (after.result == Loading::Result::Refused)
        return {"spelling refused", "is refused" + spelled + ": " + after.message};
    if (after.result == Loading::Result::Broken) return {"broken", after.fault};
    if (after.result == Loading::Result::Loaded && !after.sameStateAs(before))
        return {"spelling misread", "is another world" + spelled + ":"};
    return {"spelling understood", ""};
}

std::string classOf(const std::string &complaint) {
    std::string text;
    for (const char c :
         complaint.substr(0, std::min(complaint.find('\n'), complaint.find(": ", complaint.find(": ") + 1))))
        if (!std::isdigit(static_cast<unsigned char>(c))) text += c;
    return text.substr(0, 80);
}

}  // namespace fuzz_worlds
