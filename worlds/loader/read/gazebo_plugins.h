// What Gazebo's plugins do to motion. None of them is run here.
#pragma once

#include "loader/description/element.h"

#include <string>

namespace worlds {

enum class PluginEffect {
    MovesNothing,    // draws, measures, records or publishes
    AwaitsMessages,  // moves something only once it is sent messages; a drive may hold its wheels until then
    Unknown,         // moves something by itself, or is not known
};

// Of a <plugin> element, by its file name and what it holds.
PluginEffect pluginEffect(const Element &plugin);

// The known ones, for the documentation: names without prefixes and suffixes, parted by ", ".
std::string pluginsThat(PluginEffect effect);

}  // namespace worlds
