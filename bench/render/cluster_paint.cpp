#include "render/cluster_paint.h"

namespace render {

namespace {

constexpr Colour kWhite = {1, 1, 1}, kDark = {0.13, 0.13, 0.13}, kEdge = {0.45, 0.45, 0.45};
constexpr Colour kApart = {0.72, 0.72, 0.72}, kUnlisted = {0.97, 0.97, 0.97};
constexpr double kTint = 0.45;                              // share of white in what a cluster lists
constexpr double kThin = 0.5, kStrong = 0.9, kThick = 2.2;  // px

}  // namespace

ClusterPaint::ClusterPaint(const record::Header &header, const record::Frame &frame)
    : m_header(header),
      m_frame(frame),
      m_listsStatics(header.algorithm == "duplication" || header.algorithm == "decluster") {
    for (const record::Membership &membership : frame.memberships)
        if (membership.cluster != 0)
            m_numbers.insert({membership.cluster, static_cast<int>(m_numbers.size())});
}

Colour ClusterPaint::ofCluster(unsigned name) const {
    const auto number = m_numbers.find(name);
    return number == m_numbers.end() ? kApart : clusterColour(number->second);
}

Paint ClusterPaint::of(std::size_t geom) const {
    const record::Membership &membership = m_frame.memberships[geom];
    const bool isStatic = m_header.geoms[geom].body == record::Geom::kStatic;
    return isStatic ? ofStatic(membership) : ofMoving(membership);
}

Paint ClusterPaint::ofMoving(const record::Membership &membership) const {
    if (membership.cluster == 0) return {{kWhite}, {kDark}, kThick};
    return {{ofCluster(membership.cluster)}, {kDark}, kStrong};
}

Paint ClusterPaint::ofStatic(const record::Membership &membership) const {
    const std::vector<unsigned> &testedWith = membership.testedWith;
    if (membership.staticCluster != 0) {
        const Colour fill = staticClusterColour(static_cast<int>(membership.staticCluster) - 1);
        if (testedWith.empty()) return {{fill}, {kEdge}, kThin};
        Paint paint{{fill}, {}, kThick};
        for (unsigned name : testedWith) paint.outlines.push_back(ofCluster(name));
        return paint;
    }
    if (!m_listsStatics) return {{kApart}, {kEdge}, kThin};
    Paint paint{{}, {kEdge}, kThin};
    for (unsigned name : testedWith) paint.fills.push_back(mixed(ofCluster(name), kWhite, kTint));
    if (paint.fills.empty()) paint.fills.push_back(kUnlisted);
    return paint;
}

}  // namespace render
