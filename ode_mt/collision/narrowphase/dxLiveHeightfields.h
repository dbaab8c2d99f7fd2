// The existing data objects of height fields.
//
// A program may destroy such data while geoms have it, if it does not collide them any more: upstream then does not
// access it. Code that examines pairs before their callbacks must check here first. Threading: any thread.
#pragma once

struct dxHeightfieldData;

namespace dxLiveHeightfields {

// Without memory for the entry, the data counts as destroyed.
void add(const dxHeightfieldData *data);
void remove(const dxHeightfieldData *data);
bool has(const dxHeightfieldData *data);

}  // namespace dxLiveHeightfields
