// How each geom is painted so that one sees its cluster.
//
//   what moves         strong colour of its cluster; white with a thick outline if it is big (in none)
//   static, clustered  pale colour of its static cluster; outline in the colours of the clusters that are
//   tested with it static, listed     tint of each cluster that lists it, in stripes if they are several;
//   almost white if none does static, apart      grey: tested with every cluster
#pragma once

#include "record/recording.h"
#include "render/colour.h"

#include <map>
#include <vector>

namespace render {

struct Paint {
    std::vector<Colour> fills;     // at least one
    std::vector<Colour> outlines;  // several: in dashes
    double outlineWidth = 0.6;     // px
};

class ClusterPaint {
public:
    ClusterPaint(const record::Header &header, const record::Frame &frame);

    Paint of(std::size_t geom) const;
    Colour ofCluster(unsigned name) const;

private:
    Paint ofMoving(const record::Membership &membership) const;
    Paint ofStatic(const record::Membership &membership) const;

    const record::Header &m_header;
    const record::Frame &m_frame;
    std::map<unsigned, int> m_numbers;  // of the clusters, by name, in the order of their first geoms
    bool m_listsStatics;                // the pass lists static geoms in each cluster that is near
};

}  // namespace render
