#include "record/recording.h"

#include "loader/load_error.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <istream>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>

namespace record {

using nlohmann::json;

namespace {

// What is nested is named by its type: to write it down takes as much stack as it is deep.
std::string shown(const json &value) {
    if (value.is_structured()) return "an " + std::string(value.type_name());
    return value.is_string() ? worlds::quote(value.get<std::string>()) : value.dump();
}

// nlohmann-json would cut a fraction off, and take a number that is too large modulo 2^32.
template <typename Number>
void getWhole(const json &from, Number &to) {
    constexpr auto kMax = std::numeric_limits<Number>::max();
    const bool isWhole = from.is_number_unsigned() ? from.get<std::uint64_t>() <= static_cast<std::uint64_t>(kMax)
                                                   : from.is_number_integer() && std::is_signed_v<Number> &&
                                                         from.get<std::int64_t>() >= std::numeric_limits<Number>::min();
    if (!isWhole) throw std::runtime_error(shown(from) + " where a whole number is expected");
    to = from.get<Number>();
}

template <typename Number>
void getWhole(const json &from, std::vector<Number> &to) {
    to.clear();
    for (const json &number : from) getWhole(number, to.emplace_back());
}

}  // namespace

// nlohmann-json finds these by their names.
void to_json(json &to, const Pose &p) {
    const auto &[x, y, z] = p.position;
    const auto &[qw, qx, qy, qz] = p.quaternion;
    to = {x, y, z, qw, qx, qy, qz};
}

void from_json(const json &from, Pose &p) {
    for (std::size_t i = 0; i < 3; ++i) p.position[i] = from.at(i);
    for (std::size_t i = 0; i < 4; ++i) p.quaternion[i] = from.at(3 + i);
}

void to_json(json &to, const Geom &g) {
    to = {{"shape", g.shape.kind}, {"size", g.shape.size}, {"body", g.body}};
    if (!g.shape.triangles.empty()) to["triangles"] = g.shape.triangles;
}

void from_json(const json &from, Geom &g) {
    from.at("shape").get_to(g.shape.kind);
    from.at("size").get_to(g.shape.size);
    getWhole(from.at("body"), g.body);
    if (from.contains("triangles")) from.at("triangles").get_to(g.shape.triangles);
}

void to_json(json &to, const Header &h) {
    to = {{"world", h.world},
          {"algorithm", h.algorithm},
          {"library", h.library},
          {"stepSize", h.stepSize},
          {"geoms", h.geoms}};
}

void from_json(const json &from, Header &h) {
    from.at("world").get_to(h.world);
    from.at("algorithm").get_to(h.algorithm);
    from.at("library").get_to(h.library);
    from.at("stepSize").get_to(h.stepSize);
    from.at("geoms").get_to(h.geoms);
}

void to_json(json &to, const Grid &g) { to = {{"cells", g.cells}, {"edge", g.edge}, {"centre", g.centre}}; }

void from_json(const json &from, Grid &g) {
    getWhole(from.at("cells"), g.cells);
    from.at("edge").get_to(g.edge);
    from.at("centre").get_to(g.centre);
}

void to_json(json &to, const Cell &c) { to = {c.x, c.y, c.z, c.cluster}; }

void from_json(const json &from, Cell &c) {
    getWhole(from.at(0), c.x);
    getWhole(from.at(1), c.y);
    getWhole(from.at(2), c.z);
    getWhole(from.at(3), c.cluster);
}

void to_json(json &to, const Event &e) {
    to = {{"kind", e.isSplit ? "split" : "merge"}, {"from", e.from}, {"into", e.into}};
}

void from_json(const json &from, Event &e) {
    e.isSplit = from.at("kind") == "split";
    getWhole(from.at("from"), e.from);
    getWhole(from.at("into"), e.into);
}

void to_json(json &to, const Membership &m) {
    to = {{"cluster", m.cluster}, {"static", m.staticCluster}, {"testedWith", m.testedWith}};
}

void from_json(const json &from, Membership &m) {
    getWhole(from.at("cluster"), m.cluster);
    getWhole(from.at("static"), m.staticCluster);
    getWhole(from.at("testedWith"), m.testedWith);
}

void to_json(json &to, const Frame &f) {
    to = {{"number", f.number},     {"time", f.time},
          {"clusters", f.clusters}, {"grid", f.grid},
          {"cells", f.cells},       {"events", f.events},
          {"bodies", f.bodies},     {"bodyClusters", f.bodyClusters},
          {"geoms", f.geoms},       {"memberships", f.memberships}};
}

void from_json(const json &from, Frame &f) {
    getWhole(from.at("number"), f.number);
    from.at("time").get_to(f.time);
    getWhole(from.at("clusters"), f.clusters);
    from.at("grid").get_to(f.grid);
    from.at("cells").get_to(f.cells);
    from.at("events").get_to(f.events);
    from.at("bodies").get_to(f.bodies);
    getWhole(from.at("bodyClusters"), f.bodyClusters);
    from.at("geoms").get_to(f.geoms);
    from.at("memberships").get_to(f.memberships);
}

namespace {

// Bytes that are no UTF-8 (file names may be anything) become U+FFFD instead of an exception.
std::string dump(const json &value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

// Returns how many numbers recording.h specifies for a kind.
std::size_t numbersOf(const std::string &kind) {
    static const std::map<std::string, std::size_t> kNumbers = {
        {"box", 3}, {"sphere", 1}, {"capsule", 2}, {"cylinder", 2}, {"plane", 4}, {"mesh", 6}, {"bounds", 3}};
    const auto found = kNumbers.find(kind);
    if (found == kNumbers.end()) throw std::runtime_error("unknown shape " + worlds::quote(kind));
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

constexpr int kMaxCells = 1000;  // on each axis; the library has at most 20

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
    for (const Geom &geom : header.geoms)
        if (geom.body < Geom::kStatic || geom.body >= static_cast<long>(frame.bodies.size()))
            throw std::runtime_error("it has no body " + std::to_string(geom.body) + ", which a geom is said to have");
    for (const Pose &pose : frame.bodies) checkPose(pose, "the pose of a body");
    for (const Pose &pose : frame.geoms) checkPose(pose, "the pose of a geom");
    if (frame.geoms.size() != header.geoms.size() || frame.memberships.size() != header.geoms.size())
        throw std::runtime_error("it has not one pose and one membership for each of the " +
                                 std::to_string(header.geoms.size()) + " geoms");
}

}  // namespace

std::string writeHeader(const Header &header) { return dump({{"recording", header}}); }

std::string writeFrame(const Frame &frame) { return dump({{"frame", frame}}); }

Recording readRecording(std::istream &lines) {
    Recording recording;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        try {
            if (line.empty() && lines.peek() == std::char_traits<char>::eof()) break;  // written by an editor
            const json object = json::parse(line, nullptr, false);
            if (object.is_discarded()) throw std::runtime_error("not JSON");
            if (number == 1) {
                object.at("recording").get_to(recording.header);
                checkHeader(recording.header);
            } else {
                object.at("frame").get_to(recording.frames.emplace_back());
                checkFrame(recording.frames.back(), recording.header);
            }
        } catch (const json::out_of_range &) {
            throw std::runtime_error("line " + std::to_string(number) + ": a member or an element is missing");
        } catch (const json::exception &) {
            throw std::runtime_error("line " + std::to_string(number) + ": a value of another type than docs/clusters.md says");
        } catch (const std::exception &error) {
            throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
        }
    }
    if (number == 0) throw std::runtime_error("line 1: missing");
    return recording;
}

}  // namespace record
