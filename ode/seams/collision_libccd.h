/* What upstream hands to libccd. */
#pragma once

#include "collision/narrowphase/dxCcdQuery.h"

/* Upstream's support function of convex geoms, defined in its file. */
static void ccdSupportConvex(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *support);

/* A support function on its way to libccd: in the place of upstream's of convex geoms it is ours. */
class dxCcdSupport {
public:
    dxCcdSupport(ccd_support_fn function) : m_function(function == ccdSupportConvex ? ofConvex : function) {}
    operator ccd_support_fn() const { return m_function; }

private:
    static void ofConvex(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *support) {
        dxSupportConvex(*static_cast<const dxCcdConvex *>(object), *direction, *support);
    }

    const ccd_support_fn m_function;
};
#define ccd_support_fn dxCcdSupport

/* Its searches may be left while no caller has asked for them yet. */
#define ccdMPRIntersect dxCcdQuery::intersect
#define ccdMPRPenetration dxCcdQuery::penetration
