/* Where upstream hands libccd the support function of convex geoms by its name, it hands out ours. Its own, which has
 * arguments behind the name wherever it is declared, gets another one. */
#pragma once

#include "collision/dxCcdSearch.h"
#include "collision/dxConvexSupport.h"

static void ccdSupportConvex(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *support) {
    dxSupportConvex(*static_cast<const dxCcdConvex *>(object), *direction, *support);
}

#define ccdSupportConvex(object, direction, support) dxUpstreamSupportConvex(object, direction, support)

/* Its searches may be left while nobody has asked for them yet. */
#define ccdMPRIntersect dxCcdSearch::intersect
#define ccdMPRPenetration dxCcdSearch::penetration
