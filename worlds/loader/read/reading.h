// What the readers of a world share.
#pragma once

#include "loader/description/world_description.h"
#include "loader/load_world.h"
#include "loader/read/resource_finder.h"
#include "support/text.h"

#include <unordered_set>

namespace worlds {

// What happens when a world holds something that is not supported, missing, or read in another way than it is written.
class Issues {
public:
    explicit Issues(const LoadOptions &options) : m_options(options) {}

    // Throws, or records the issue and returns if the user asked to continue.
    void unsupported(const Place &place, const std::string &what = {}) const {
        leaveOut(LoadError::Kind::Unsupported, place, what.empty() ? "not supported" : what + ": not supported");
    }
    // The same for a model or file that is not there.
    void missing(const Place &place, const std::string &what) const { leaveOut(LoadError::Kind::Resource, place, what); }

    // The same for one that is broken.
    void missing(const LoadError &error) const { leaveOut(error.kind(), error.place(), error.reason()); }

    // Records what the user should know of a world that is read nevertheless.
    void warn(const Place &place, const std::string &what) const {
        const std::string text = toString(place) + ": " + support::printable(what);
        if (m_options.warnings && m_known.insert(text).second) m_options.warnings->push_back(text);
    }

private:
    void leaveOut(LoadError::Kind kind, const Place &place, const std::string &what) const {
        if (m_options.ignoreUnsupported) return warn(place, what + "; left out");
        const std::string &option = m_options.ignoringOption;
        throw LoadError(kind, place, option.empty() ? what : what + "; " + option + " leaves it out");
    }

    const LoadOptions &m_options;
    mutable std::unordered_set<std::string> m_known;  // warnings
};

struct Reading {
    const ResourceFinder &resources;
    const Issues &issues;
};

}  // namespace worlds
