#include "record/recording.h"

#include "support/text.h"
#include "record/recording_check.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <istream>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace record {

using nlohmann::json;

namespace {

// What is nested is named by its type: to write it down takes as much stack as it is deep.
std::string shown(const json &value) {
    if (value.is_structured()) return "an " + std::string(value.type_name());
    return value.is_string() ? support::quote(value.get<std::string>()) : value.dump();
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

// Returns the number with six digits.
double rounded(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return std::strtod(text, nullptr);
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
    if (!h.bodyNames.empty()) to["bodyNames"] = h.bodyNames;
}

void from_json(const json &from, Header &h) {
    from.at("world").get_to(h.world);
    from.at("algorithm").get_to(h.algorithm);
    from.at("library").get_to(h.library);
    from.at("stepSize").get_to(h.stepSize);
    from.at("geoms").get_to(h.geoms);
    if (from.contains("bodyNames")) from.at("bodyNames").get_to(h.bodyNames);
}

void to_json(json &to, const Velocity &v) { to = {v.linear[0], v.linear[1], v.linear[2], v.angular[0], v.angular[1], v.angular[2]}; }

void from_json(const json &from, Velocity &v) {
    for (std::size_t i = 0; i < 3; ++i) {
        from.at(i).get_to(v.linear[i]);
        from.at(3 + i).get_to(v.angular[i]);
    }
}

void to_json(json &to, const Contact &c) {
    to = {c.geom1, c.geom2};
    for (const Vector *vector : {&c.position, &c.normal, &c.force})
        for (const double number : *vector) to.push_back(rounded(number));
    to.push_back(rounded(c.depth));
}

void from_json(const json &from, Contact &c) {
    getWhole(from.at(0), c.geom1);
    getWhole(from.at(1), c.geom2);
    for (std::size_t i = 0; i < 3; ++i) {
        from.at(2 + i).get_to(c.position[i]);
        from.at(5 + i).get_to(c.normal[i]);
        from.at(8 + i).get_to(c.force[i]);
    }
    from.at(11).get_to(c.depth);
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
    if (!f.velocities.empty()) to["velocities"] = f.velocities;
    if (!f.awake.empty()) to["awake"] = f.awake;
    if (!f.islands.empty()) to["islands"] = f.islands;
    if (!f.workers.empty()) to["workers"] = f.workers;
    if (f.contacts) to["contacts"] = *f.contacts;
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
    if (from.contains("velocities")) from.at("velocities").get_to(f.velocities);
    if (from.contains("awake")) from.at("awake").get_to(f.awake);
    if (from.contains("islands")) getWhole(from.at("islands"), f.islands);
    if (from.contains("workers")) getWhole(from.at("workers"), f.workers);
    if (from.contains("contacts")) f.contacts = from.at("contacts").get<std::vector<Contact>>();
}

namespace {

// Bytes that are no UTF-8 (file names may be anything) become U+FFFD instead of an exception.
std::string dump(const json &value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

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
