// What is demanded of the loader, tried with one case.
#pragma once

#include "worlds/forbidden_change.h"
#include "worlds/loading.h"
#include "worlds/spelling.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fuzz_worlds {

struct Judgement {
    std::string kind;       // counted
    std::string complaint;  // empty: as it should be; else a class of complaints, a colon and more
};

class Judge {
public:
    explicit Judge(const std::filesystem::path &folder) : m_folder(folder) {}

    // It loads and can run, or is refused as message_rule.h requires; nothing else is allowed.
    Judgement loads(const WorldCase &world);

    // If the world loads, then not any more with the change, and the error names the place.
    Judgement refuses(const WorldCase &world, const ForbiddenChange &change);

    // If the world loads, then with the same bits when it is spelled otherwise.
    Judgement understands(const WorldCase &world, const std::vector<Spelling> &ways, std::uint64_t seed);

private:
    Loading load(const WorldCase &world);

    std::filesystem::path m_folder;
};

// What remains of the complaint when the numbers in it do not count: equal for the same fault.
std::string classOf(const std::string &complaint);

}  // namespace fuzz_worlds
