// The list of fields: everything of the state of ODE that the public API lets a program see.
//
// The recorder, the dump and the comparison are all made from this one list, so that no field can be
// recorded and not compared. A field reads through the public API only.
#pragma once

#include "names.h"
#include "reading.h"

#include <functional>
#include <string>
#include <vector>

namespace exactness {

enum class Kind { Process, World, Space, Body, Joint, Geom, Event };
const char *toString(Kind kind);

template <class Handle>
struct Field {
    const char *name;
    void (*read)(Handle handle, const Names &names, Reading &reading);
};

const std::vector<Field<dWorldID>> &worldFields();
const std::vector<Field<dSpaceID>> &spaceFields();
const std::vector<Field<dBodyID>> &bodyFields();
const std::vector<Field<dGeomID>> &geomFields();
const std::vector<Field<dJointID>> &jointFields();                 // of every joint
const std::vector<Field<dJointID>> &jointFields(dJointType type);  // of one type alone

// Receives what was read. `index` is a place in the scene's inventory; of an event, its number.
using Witness = std::function<void(Kind kind, std::size_t index, const char *field, const Reading &reading)>;

// Reads every field of everything the scene lists.
void readState(const scenes::Inventory &inventory, const Names &names, const Witness &witness);

// "body: position", one line for each field, for people.
std::vector<std::string> describeFields();

}  // namespace exactness
