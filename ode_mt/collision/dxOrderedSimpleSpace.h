// The simple space: all pairs, each geom with those behind it in the list, from the front on.
#pragma once

#include <memory>

#include "collision/dxDensePairs.h"
#include "collision/dxOrderedSpace.h"

class dxOrderedSimpleSpace final : public dxOrderedSpace {
public:
    explicit dxOrderedSimpleSpace(dSpaceID parent) : dxOrderedSpace(parent, dSimpleSpaceClass) {}

    void collide(void *data, dNearCallback *callback) override;

private:
    void update(std::vector<dxOrderedPair> &pairs) override;
    bool place(Slot a, Slot b, dxPairKey &key, bool &swapped) const override;
    void expect(Slot a, Slot b) const override;

    void collidePairs(void *data, dNearCallback *callback);
    void collideList(void *data, dNearCallback *callback);

    std::unique_ptr<dxDensePairs> m_dense;  // while the space is small
};
