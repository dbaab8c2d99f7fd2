#include "collision/narrowphase/dxCcdQuery.h"

#include "threading/dxUpstreamScope.h"

namespace {

// Upstream limits the last phase to 500 iterations (ccdCollide in collision_libccd.cpp); libccd does not limit the
// earlier ones, which take about ten.
constexpr unsigned kMaxCcdIterations = 2000;

__attribute__((tls_model("initial-exec"))) thread_local bool t_isLimited = false;

// Counts iterations. It replaces the first object: libccd calls the support function of each object in every iteration.
class Counted {
public:
    Counted(const void *object, const ccd_t &search) : m_object(object), m_support(search.support1), m_center(search.center1) {}

    static ccd_t counting(ccd_t search) {
        search.support1 = [](const void *object, const ccd_vec3_t *direction, ccd_vec3_t *point) {
            const auto &counted = *static_cast<const Counted *>(object);
            if (counted.m_iterations++ == kMaxCcdIterations) throw dxUpstreamInterrupted();
            counted.m_support(counted.m_object, direction, point);
        };
        search.center1 = [](const void *object, ccd_vec3_t *center) {
            const auto &counted = *static_cast<const Counted *>(object);
            counted.m_center(counted.m_object, center);
        };
        return search;
    }

private:
    const void *const m_object;
    const ccd_support_fn m_support;
    const ccd_center_fn m_center;
    mutable unsigned m_iterations = 0;  // libccd hands objects on as const
};

}  // namespace

dxCcdQuery::Limit::Limit() : m_outer(t_isLimited) { t_isLimited = true; }
dxCcdQuery::Limit::~Limit() { t_isLimited = m_outer; }

int dxCcdQuery::intersect(const void *object1, const void *object2, const ccd_t *search) {
    if (!t_isLimited) return ccdMPRIntersect(object1, object2, search);
    const Counted counted(object1, *search);
    const ccd_t counting = Counted::counting(*search);
    return ccdMPRIntersect(&counted, object2, &counting);
}

int dxCcdQuery::penetration(const void *object1, const void *object2, const ccd_t *search, ccd_real_t *depth, ccd_vec3_t *direction,
                             ccd_vec3_t *position) {
    if (!t_isLimited) return ccdMPRPenetration(object1, object2, search, depth, direction, position);
    const Counted counted(object1, *search);
    const ccd_t counting = Counted::counting(*search);
    return ccdMPRPenetration(&counted, object2, &counting, depth, direction, position);
}
