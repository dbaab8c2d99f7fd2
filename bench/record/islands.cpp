#include "record/islands.h"

#include <unordered_map>

namespace record {

namespace {

using Islands = std::unordered_map<dBodyID, int>;

// Bodies that a scene does not list are passed through, too.
void visit(dBodyID first, int island, Islands &islands) {
    std::vector<dBodyID> open = {first};
    islands.emplace(first, island);
    while (!open.empty()) {
        const dBodyID body = open.back();
        open.pop_back();
        for (int i = 0; i < dBodyGetNumJoints(body); ++i) {
            const dJointID joint = dBodyGetJoint(body, i);
            if (!dJointIsEnabled(joint)) continue;
            for (const int side : {0, 1}) {
                const dBodyID other = dJointGetBody(joint, side);
                if (other && dBodyIsEnabled(other) && islands.emplace(other, island).second) open.push_back(other);
            }
        }
    }
}

}  // namespace

std::vector<int> islandsOf(const std::vector<dBodyID> &bodies) {
    Islands islands;
    int count = 0;
    std::vector<int> found;
    for (const dBodyID body : bodies) {
        if (dBodyIsEnabled(body) && islands.count(body) == 0) visit(body, count++, islands);
        const auto island = islands.find(body);
        found.push_back(island == islands.end() ? kNoIsland : island->second);
    }
    return found;
}

}  // namespace record
