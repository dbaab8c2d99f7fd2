#include "record/other_world.h"

#include "support/text.h"
#include "number_text.h"

#include <algorithm>
#include <filesystem>

namespace record {

namespace {

// A file may have been recorded from another folder.
std::string nameOf(const std::string &world) { return std::filesystem::path(world).filename(); }

std::string counted(std::size_t number, const char *thing) { return std::to_string(number) + ' ' + thing + (number == 1 ? "" : "s"); }

bool areEqual(const Geom &one, const Geom &other) {
    return one.body == other.body && one.shape.kind == other.shape.kind && one.shape.size == other.shape.size &&
           one.shape.triangles == other.shape.triangles;
}

std::string difference(const Header &one, const Header &other) {
    if (nameOf(one.world) != nameOf(other.world)) return support::quote(one.world) + " and " + support::quote(other.world);
    if (one.geoms.size() != other.geoms.size())
        return counted(one.geoms.size(), "geom") + " in the first, " + std::to_string(other.geoms.size()) + " in the second";
    const auto [geom, twin] = std::mismatch(one.geoms.begin(), one.geoms.end(), other.geoms.begin(), areEqual);
    if (geom != one.geoms.end()) return "geom " + std::to_string(geom - one.geoms.begin()) + " has another shape, size or body in the second";
    if (one.bodyNames != other.bodyNames) return "bodies have other names in the second";
    if (one.stepSize != other.stepSize)
        return "steps of " + bench::numberText(1e3 * one.stepSize) + " ms in the first, of " + bench::numberText(1e3 * other.stepSize) + " ms in the second";
    return "";
}

}  // namespace

std::string whyOtherWorld(const Header &one, const Header &other) {
    const std::string found = difference(one, other);
    return found.empty() ? "" : "The recordings are of different worlds: " + found + ". That frames differ says nothing about engines.";
}

}  // namespace record
