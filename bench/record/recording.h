// A recording: what moved in a scene, and in which cluster everything was, as plain data and as JSON lines.
//
//   first line  {"recording": {…}}   what was run, and the shape of each geom
//   then        {"frame": {…}}       one line for each frame that was kept
//
// docs/clusters.md describes each member. Lengths are in m, times in s, quaternions (w, x, y, z). Geoms and
// bodies are known by their places in the lists, from 0.
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace record {

using Vector = std::array<double, 3>;
using Triangle = std::array<Vector, 3>;

struct Pose {
    Vector position{};
    std::array<double, 4> quaternion{1, 0, 0, 0};
};

struct Velocity {
    Vector linear{}, angular{};  // m/s, rad/s
};

// kind and size: "box" (edges), "sphere" (radius), "capsule" and "cylinder" (radius, length along z),
// "plane" (a, b, c, d of ax + by + cz = d), "mesh" (lower corner, upper corner; its triangles, too, if they
// are few), "bounds" (edges of the bounding box in the world's axes): any other kind.
struct Shape {
    std::string kind;
    std::vector<double> size;
    std::vector<Triangle> triangles;
};

struct Geom {
    static constexpr int kStatic = -1;

    Shape shape;
    int body = kStatic;
};

struct Header {
    std::string world, algorithm, library;
    double stepSize = 0;
    std::vector<Geom> geoms;
    std::vector<std::string> bodyNames;  // of the bodies; empty: they have none
};

struct Grid {
    int cells = 0;  // on each axis; 0: no grid
    double edge = 0;
    Vector centre{};
};

struct Cell {
    int x = 0, y = 0, z = 0;
    unsigned cluster = 0;
};

struct Event {
    bool isSplit = false;  // false: `from` became part of `into`; true: `into` came off `from`
    unsigned from = 0, into = 0;
};

// The clusters of one geom. 0: none.
struct Membership {
    unsigned cluster = 0;              // name, of what moves
    unsigned staticCluster = 0;        // number in this frame
    std::vector<unsigned> testedWith;  // names
};

// A contact joint. What is shown only, so that six digits are kept.
struct Contact {
    static constexpr int kUnknown = -1;

    int geom1 = kUnknown, geom2 = kUnknown;
    Vector position{}, normal{};  // normal: into geom1
    double depth = 0;
    Vector force{};  // N, on geom1
};

struct Frame {
    long number = 0;  // frames that had run
    double time = 0;
    int clusters = 0;
    Grid grid;
    std::vector<Cell> cells;    // in which something that moves lies
    std::vector<Event> events;  // since the last frame in this recording
    std::vector<Pose> bodies;
    std::vector<unsigned> bodyClusters;
    std::vector<Pose> geoms;
    std::vector<Membership> memberships;  // of the geoms

    // Of the bodies; empty in recordings of earlier versions, which have none of these members.
    std::vector<Velocity> velocities;
    std::vector<bool> awake;
    std::vector<int> islands;                      // numbers in this frame; -1: asleep
    std::vector<int> workers;                      // that stepped them, 0: the caller; -1: none; empty: was not asked for
    std::optional<std::vector<Contact>> contacts;  // if they were asked for
};

struct Recording {
    Header header;
    std::vector<Frame> frames;
};

std::string writeHeader(const Header &header);  // one line, without its end
std::string writeFrame(const Frame &frame);

// Throws std::runtime_error, naming the invalid line.
Recording readRecording(std::istream &lines);

}  // namespace record
