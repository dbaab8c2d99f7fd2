// Which data of height fields is there.
//
// A program may destroy such data while geoms have it, if it does not collide them any more: upstream then does not look
// at it. Whoever looks at pairs before their callbacks asks here first. Any thread.
#pragma once

struct dxHeightfieldData;

namespace dxLivingHeights {

// Where there is no memory to note it, the data counts as gone.
void add(const dxHeightfieldData *data);
void remove(const dxHeightfieldData *data);
bool has(const dxHeightfieldData *data);

}  // namespace dxLivingHeights
