// What the readers of a world share.
#pragma once

#include "loader/description/world_description.h"
#include "loader/load_world.h"
#include "loader/read/resource_finder.h"

namespace worlds {

// What happens when a world holds something that is not supported.
class Issues {
public:
    explicit Issues(const LoadOptions &options) : m_options(options) {}

    // Throws, or records the issue and returns if the user asked to continue.
    void unsupported(const Place &place, const std::string &what = {}) const {
        const LoadError error(LoadError::Kind::Unsupported, place,
                              what.empty() ? "not supported" : what + ": not supported");
        if (!m_options.ignoreUnsupported) throw error;
        if (m_options.warnings) m_options.warnings->push_back(error.what());
    }

private:
    const LoadOptions &m_options;
};

struct Reading {
    const ResourceFinder &resources;
    const Issues &issues;
};

}  // namespace worlds
