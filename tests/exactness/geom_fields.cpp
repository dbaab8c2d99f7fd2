#include "field_readers.h"

namespace exactness {

namespace {

// Planes and spaces have no pose, and asking for one is an error.
bool hasPose(dGeomID geom) { return dGeomGetClass(geom) != dPlaneClass; }

void readPosition(dGeomID geom, const Names &, Reading &reading) {
    if (hasPose(geom)) reading.reals(dGeomGetPosition(geom), 3);
}

void readRotation(dGeomID geom, const Names &, Reading &reading) {
    if (hasPose(geom)) readMatrix(dGeomGetRotation(geom), reading);
}

void readBox(dGeomID geom, const Names &, Reading &reading) {
    dReal box[6];
    dGeomGetAABB(geom, box);
    reading.reals(box, 6);
}

void readSpaceBox(dSpaceID space, const Names &names, Reading &reading) {
    readBox(reinterpret_cast<dGeomID>(space), names, reading);
}

void readBody(dGeomID geom, const Names &names, Reading &reading) {
    reading.integer(names.of(dGeomGetBody(geom)));
}

void readSpace(dGeomID geom, const Names &names, Reading &reading) {
    reading.integer(names.of(reinterpret_cast<dGeomID>(dGeomGetSpace(geom))));
}

void readBits(dGeomID geom, const Names &, Reading &reading) {
    reading.integer(static_cast<std::int64_t>(dGeomGetCategoryBits(geom)));
    reading.integer(static_cast<std::int64_t>(dGeomGetCollideBits(geom)));
}

// A quad-tree space cannot enumerate its geoms: dSpaceGetGeom ends the program.
void readOrder(dSpaceID space, const Names &names, Reading &reading) {
    if (dSpaceGetClass(space) == dQuadTreeSpaceClass) return;
    const int count = dSpaceGetNumGeoms(space);
    for (int i = 0; i < count; ++i) reading.integer(names.of(dSpaceGetGeom(space, i)));
}

}  // namespace

const std::vector<Field<dGeomID>> &geomFields() {
    static const std::vector<Field<dGeomID>> fields{
        {"position", readPosition},
        {"rotation", readRotation},
        {"bounding box", readBox},
        {"class", readInteger<dGeomID, dGeomGetClass>},
        {"enabled", readInteger<dGeomID, dGeomIsEnabled>},
        {"body", readBody},
        {"space", readSpace},
        {"category and collide bits", readBits},
    };
    return fields;
}

const std::vector<Field<dSpaceID>> &spaceFields() {
    static const std::vector<Field<dSpaceID>> fields{
        {"number of geoms", readInteger<dSpaceID, dSpaceGetNumGeoms>},
        {"order of geoms", readOrder},
        {"bounding box", readSpaceBox},
        {"class", readInteger<dSpaceID, dSpaceGetClass>},
        {"cleanup", readInteger<dSpaceID, dSpaceGetCleanup>},
        {"sublevel", readInteger<dSpaceID, dSpaceGetSublevel>},
    };
    return fields;
}

}  // namespace exactness
