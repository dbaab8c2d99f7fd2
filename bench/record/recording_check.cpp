#include "record/recording_check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "table.h"
#include "support/text.h"

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
        return "steps of " + bench::numberText(1e3 * one.stepSize) + " ms in the first, of " + bench::numberText(1e3 * other.stepSize) +
               " ms in the second";
    return "";
}

}  // namespace

std::string whyOtherWorld(const Header &one, const Header &other) {
    const std::string found = difference(one, other);
    return found.empty() ? "" : "The recordings are of different worlds: " + found + ". That frames differ says nothing about engines.";
}

namespace {

// Returns how many numbers recording.h specifies for a kind.
std::size_t numbersOf(const std::string &kind) {
    static const std::map<std::string, std::size_t> kNumbers = {
        {"box", 3}, {"sphere", 1}, {"capsule", 2}, {"cylinder", 2}, {"plane", 4}, {"mesh", 6}, {"bounds", 3}};
    const auto found = kNumbers.find(kind);
    if (found == kNumbers.end()) throw std::runtime_error("unknown shape " + support::quote(kind));
    return found->second;
}

// Neither nan nor so large that it cannot be drawn.
void checkNumber(double number, const std::string &what) {
    constexpr double kLargest = 1e16;  // as in the worlds that are recorded
    if (!(std::abs(number) <= kLargest))
        throw std::runtime_error(what + " holds a number that is not from -1e16 to 1e16");
}

void checkPose(const Pose &pose, const std::string &what) {
    for (const double number : pose.position) checkNumber(number, what);
    for (const double number : pose.quaternion) checkNumber(number, what);
}

}  // namespace

void checkHeader(const Header &header) {
    for (std::size_t i = 0; i < header.geoms.size(); ++i) {
        const Shape &shape = header.geoms[i].shape;
        const std::size_t expected = numbersOf(shape.kind);
        if (shape.size.size() != expected)
            throw std::runtime_error("geom " + std::to_string(i) + ": the size of a " + shape.kind + " has " +
                                     std::to_string(expected) + " numbers, not " +
                                     std::to_string(shape.size.size()));
        for (const double number : shape.size) {
            if (number < 0 && shape.kind != "plane" && shape.kind != "mesh")
                throw std::runtime_error("geom " + std::to_string(i) + ": a size below 0");
            checkNumber(number, "geom " + std::to_string(i));
        }
        for (const Triangle &triangle : shape.triangles)
            for (const auto &corner : triangle)
                for (const double number : corner) checkNumber(number, "geom " + std::to_string(i));
    }
}

namespace {

void checkContact(const Contact &contact, const Header &header) {
    for (const int geom : {contact.geom1, contact.geom2})
        if (geom < Contact::kUnknown || geom >= static_cast<long>(header.geoms.size()))
            throw std::runtime_error("it has no geom " + std::to_string(geom) + ", which is said to be in contact");
    for (const Vector &vector : {contact.position, contact.normal, contact.force})
        for (const double number : vector) checkNumber(number, "a contact");
    checkNumber(contact.depth, "a contact");
}

// What is not recorded is empty.
void checkBodies(const Frame &frame) {
    for (const auto &[what, count] : {std::pair{"velocity", frame.velocities.size()}, {"state of sleep", frame.awake.size()},
                                      {"island", frame.islands.size()}, {"worker", frame.workers.size()}})
        if (count != 0 && count != frame.bodies.size())
            throw std::runtime_error("it has not one " + std::string(what) + " for each of its " + std::to_string(frame.bodies.size()) +
                                     " bodies");
    for (const Velocity &velocity : frame.velocities)
        for (const Vector &vector : {velocity.linear, velocity.angular})
            for (const double number : vector) checkNumber(number, "the velocity of a body");
    for (const int island : frame.islands)
        if (island < -1) throw std::runtime_error("a body's island is " + std::to_string(island));
    for (const int worker : frame.workers)
        if (worker < -1) throw std::runtime_error("a body's worker is " + std::to_string(worker));
}

constexpr int kMaxCells = 1000;  // on each axis; the library has at most 20

}  // namespace

// Poses and memberships of all geoms, and a grid that can be drawn.
void checkFrame(const Frame &frame, const Header &header) {
    if (frame.grid.cells < 0 || frame.grid.cells > kMaxCells)
        throw std::runtime_error("its grid has " + std::to_string(frame.grid.cells) +
                                 " cells on each axis; known: 0 to " + std::to_string(kMaxCells));
    checkNumber(frame.grid.edge, "its grid");
    for (const double number : frame.grid.centre) checkNumber(number, "its grid");
    for (const Cell &cell : frame.cells)
        for (const int place : {cell.x, cell.y, cell.z})
            if (place < 0 || place >= frame.grid.cells)
                throw std::runtime_error("a cell is not in its grid: " + std::to_string(place));
    if (frame.bodyClusters.size() != frame.bodies.size())
        throw std::runtime_error("it has not one cluster for each of its " + std::to_string(frame.bodies.size()) +
                                 " bodies");
    if (header.bodyNames.size() > frame.bodies.size())
        throw std::runtime_error("it has " + std::to_string(frame.bodies.size()) + " bodies, and there are " +
                                 std::to_string(header.bodyNames.size()) + " names of bodies");
    for (const Geom &geom : header.geoms)
        if (geom.body < Geom::kStatic || geom.body >= static_cast<long>(frame.bodies.size()))
            throw std::runtime_error("it has no body " + std::to_string(geom.body) + ", which a geom is said to have");
    checkBodies(frame);
    if (frame.contacts)
        for (const Contact &contact : *frame.contacts) checkContact(contact, header);
    for (const Pose &pose : frame.bodies) checkPose(pose, "the pose of a body");
    for (const Pose &pose : frame.geoms) checkPose(pose, "the pose of a geom");
    if (frame.geoms.size() != header.geoms.size() || frame.memberships.size() != header.geoms.size())
        throw std::runtime_error("it has not one pose and one membership for each of the " +
                                 std::to_string(header.geoms.size()) + " geoms");
}

}  // namespace record
