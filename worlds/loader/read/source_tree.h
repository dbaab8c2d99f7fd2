// A world's file and all files that it includes, checked as they were written and made ready for
// libsdformat, which by itself searches included files in the working folder first and drops an
// <include> within an included model that it cannot find.
#pragma once

#include "loader/load_error.h"
#include "loader/read/resource_finder.h"

#include <tinyxml2.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace worlds {

class MemoryFile;

class SourceTree {
public:
    // Throws LoadError.
    SourceTree(const std::string &text, const std::string &file, const ResourceFinder &resources);
    ~SourceTree();

    // The world's text; every <include> names a file that can be opened, for as long as this object lives.
    const std::string &text() const { return m_world.text; }

    // The file that the user knows, for one that libsdformat opened; any other name is returned unchanged.
    const std::string &nameOf(const std::string &opened) const;

    // Maps a line of what libsdformat opened to the user's file. Lines are those of text().
    // The path is empty for lines below 1.
    Place placeOf(const std::string &openedOrFile, int line) const;

    // The first place that has, or refers to, a name in a message of libsdformat's; the whole world when
    // there is none.
    Place placeNamedIn(const std::string &message) const;

private:
    struct Source {
        std::string file;       // that the user knows
        std::string opened;     // by libsdformat
        std::string text;       // as it is to be read
        std::string outerPath;  // of the element around the included model
        std::string givenName;  // by <include>; empty: its own
        std::string modelName;
        std::size_t modelCount = 0;  // with those that it includes
    };

    void readWorld(const std::string &text, const std::string &file);
    const Source &source(const std::string &file, const Place &includedAt, const std::string &outerPath,
                         const std::string &givenName);
    Source readSource(const std::string &file, const std::string &outerPath, const std::string &givenName);
    std::string include(tinyxml2::XMLElement &element, const Place &place, const std::string &file,
                        std::size_t &modelCount);

    const ResourceFinder &m_resources;
    Source m_world;
    std::map<std::string, Source> m_sources;         // by canonical name
    std::map<std::string, const Source *> m_byName;  // those of m_sources, by `opened` and by `file`
    std::vector<std::string> m_chain;                // canonical names of files being read, outermost first
    std::vector<std::unique_ptr<MemoryFile>> m_memoryFiles;
};

}  // namespace worlds
