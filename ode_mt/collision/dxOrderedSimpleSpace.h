// The simple space: all pairs, each geom with those behind it in the list, from the front on.
#pragma once

#include "collision/dxOrderedListSpace.h"

class dxOrderedSimpleSpace final : public dxOrderedListSpace {
public:
    explicit dxOrderedSimpleSpace(dSpaceID parent) : dxOrderedListSpace(parent, dSimpleSpaceClass) {}

    void collide(void *data, dNearCallback *callback) override;

private:
    void collideList(void *data, dNearCallback *callback);
};
