#include "fields.h"

namespace exactness {

namespace {

template <class Handle>
void readFields(const std::vector<Field<Handle>> &fields, Kind kind, std::size_t index, Handle handle,
                const Names &names, const Witness &witness) {
    static thread_local Reading reading;
    for (const Field<Handle> &field : fields) {
        reading.clear();
        field.read(handle, names, reading);
        witness(kind, index, field.name, reading);
    }
}

template <class Handle>
void readAll(const std::vector<Handle> &handles, const std::vector<Field<Handle>> &fields, Kind kind,
             const Names &names, const Witness &witness) {
    for (std::size_t i = 0; i < handles.size(); ++i) readFields(fields, kind, i, handles[i], names, witness);
}

void readProcess(const Witness &witness) {
    Reading reading;
    reading.integer(static_cast<std::int64_t>(dRandGetSeed()));
    witness(Kind::Process, 0, "random seed", reading);
}

void readJoints(const std::vector<dJointID> &joints, const Names &names, const Witness &witness) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        readFields(jointFields(), Kind::Joint, i, joints[i], names, witness);
        // Upstream's getters of most types dereference the bodies without a check.
        const bool isAttached =
            dJointGetBody(joints[i], 0) != nullptr || dJointGetBody(joints[i], 1) != nullptr;
        if (!isAttached) continue;
        readFields(jointFields(dJointGetType(joints[i])), Kind::Joint, i, joints[i], names, witness);
    }
}

template <class Handle>
void describe(Kind kind, const std::vector<Field<Handle>> &fields, std::vector<std::string> &lines) {
    for (const Field<Handle> &field : fields) {
        lines.push_back(std::string(toString(kind)) + ": " + field.name);
    }
}

}  // namespace

const char *toString(Kind kind) {
    switch (kind) {
        case Kind::Process:
            return "process";
        case Kind::World:
            return "world";
        case Kind::Space:
            return "space";
        case Kind::Body:
            return "body";
        case Kind::Joint:
            return "joint";
        case Kind::Geom:
            return "geom";
        case Kind::Event:
            return "event";
    }
    return "?";
}

void readState(const scenes::Inventory &inventory, const Names &names, const Witness &witness) {
    readProcess(witness);
    readAll(inventory.worlds, worldFields(), Kind::World, names, witness);
    readAll(inventory.bodies, bodyFields(), Kind::Body, names, witness);
    readJoints(inventory.joints, names, witness);
    readAll(inventory.spaces, spaceFields(), Kind::Space, names, witness);
    readAll(inventory.geoms, geomFields(), Kind::Geom, names, witness);
}

std::vector<std::string> describeFields() {
    std::vector<std::string> lines{"process: random seed"};
    describe(Kind::World, worldFields(), lines);
    describe(Kind::Body, bodyFields(), lines);
    describe(Kind::Joint, jointFields(), lines);
    for (int type = dJointTypeBall; type <= dJointTypeTransmission; ++type) {
        describe(Kind::Joint, jointFields(static_cast<dJointType>(type)), lines);
    }
    describe(Kind::Space, spaceFields(), lines);
    describe(Kind::Geom, geomFields(), lines);
    return lines;
}

}  // namespace exactness
