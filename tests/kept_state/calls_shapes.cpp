// Recipes for the functions of collision.h that are for geoms of one class.
#include "call_recipes.h"
#include "call_shapes.h"

namespace kept_state {

namespace {

void destroyCreated(CallScene &s) {
    const dGeomID geom = s.created();
    s.drop(geom);
    dGeomDestroy(geom);
}

// A new geom among those of its place.
void settle(CallScene &s, dGeomID geom) {
    s.adopt(geom);
    if (dGeomGetClass(geom) != dPlaneClass) dGeomSetPosition(geom, 0.6, 0.5, 0.4);
}

void addCreators(CallRecipes &r) {
    const auto create = [&](const char *name, dGeomID (*make)(dSpaceID)) {
        r.push_back({name, [make](CallScene &s) { settle(s, make(s.set().space)); }, destroyCreated});
    };
    create("dCreateSphere", [](dSpaceID space) { return dCreateSphere(space, 0.3); });
    create("dCreateBox", [](dSpaceID space) { return dCreateBox(space, 0.5, 0.4, 0.3); });
    create("dCreateCapsule", [](dSpaceID space) { return dCreateCapsule(space, 0.2, 0.4); });
    create("dCreateCylinder", [](dSpaceID space) { return dCreateCylinder(space, 0.2, 0.4); });
    create("dCreatePlane", [](dSpaceID space) { return dCreatePlane(space, 1, 0, 0, -0.2); });
    create("dCreateRay", [](dSpaceID space) { return dCreateRay(space, 2); });
    create("dCreateConvex", [](dSpaceID space) {
        const ConvexArrays a = convexArrays(1);
        return dCreateConvex(space, a.planes, a.planeCount, a.points, a.pointCount, a.polygons);
    });
    create("dCreateGeomTransform", [](dSpaceID space) {
        const dGeomID transform = dCreateGeomTransform(space);
        dGeomTransformSetGeom(transform, dCreateSphere(nullptr, 0.3));
        dGeomTransformSetCleanup(transform, 1);
        return transform;
    });
}

void addSetters(CallRecipes &r) {
    r.push_back({"dGeomSphereSetRadius", [](CallScene &s) { dGeomSphereSetRadius(s.set().sphere, 0.6); },
                 [](CallScene &s) { dGeomSphereSetRadius(s.set().sphere, 0.2); }});
    r.push_back({"dGeomBoxSetLengths", [](CallScene &s) { dGeomBoxSetLengths(s.set().box, 1.2, 0.8, 0.6); },
                 [](CallScene &s) { dGeomBoxSetLengths(s.set().box, 0.4, 0.35, 0.3); }});
    r.push_back({"dGeomCapsuleSetParams",
                 [](CallScene &s) { dGeomCapsuleSetParams(s.set().capsule, 0.4, 0.8); },
                 [](CallScene &s) { dGeomCapsuleSetParams(s.set().capsule, 0.15, 0.3); }});
    r.push_back({"dGeomCylinderSetParams",
                 [](CallScene &s) { dGeomCylinderSetParams(s.set().cylinder, 0.4, 0.8); },
                 [](CallScene &s) { dGeomCylinderSetParams(s.set().cylinder, 0.2, 0.4); }});
    r.push_back({"dGeomPlaneSetParams",
                 [](CallScene &s) { dGeomPlaneSetParams(s.set().plane, 0, 0, 1, 0.3); },
                 [](CallScene &s) { dGeomPlaneSetParams(s.set().plane, 0, 0, 1, 0); }});
    r.push_back({"dGeomRaySetLength", [](CallScene &s) { dGeomRaySetLength(s.set().ray, 1.2); },
                 [](CallScene &s) { dGeomRaySetLength(s.set().ray, 3); }});
    r.push_back({"dGeomRaySet", [](CallScene &s) { dGeomRaySet(s.set().ray, 0, 0, 2, 0.3, 0.3, -1); },
                 [](CallScene &s) { dGeomRaySet(s.set().ray, 0.3, 0.3, 2, 0.1, 0.05, -1); }});
    r.push_back({"dGeomRaySetParams", [](CallScene &s) { dGeomRaySetParams(s.set().ray, 1, 1); },
                 [](CallScene &s) { dGeomRaySetParams(s.set().ray, 0, 0); }});
    r.push_back({"dGeomRaySetFirstContact", [](CallScene &s) { dGeomRaySetFirstContact(s.set().ray, 1); },
                 [](CallScene &s) { dGeomRaySetFirstContact(s.set().ray, 0); }});
    r.push_back({"dGeomRaySetBackfaceCull", [](CallScene &s) { dGeomRaySetBackfaceCull(s.set().ray, 1); },
                 [](CallScene &s) { dGeomRaySetBackfaceCull(s.set().ray, 0); }});
    r.push_back({"dGeomRaySetClosestHit", [](CallScene &s) { dGeomRaySetClosestHit(s.set().ray, 1); },
                 [](CallScene &s) { dGeomRaySetClosestHit(s.set().ray, 0); }});
    const auto setConvex = [](int version) {
        return [version](CallScene &s) {
            const ConvexArrays a = convexArrays(version);
            dGeomSetConvex(s.set().convex, a.planes, a.planeCount, a.points, a.pointCount, a.polygons);
        };
    };
    r.push_back({"dGeomSetConvex", setConvex(1), setConvex(0)});
    r.push_back({"dGeomTransformSetGeom", [](CallScene &s) {
                     const dGeomID sphere = dCreateSphere(nullptr, 0.5);
                     dGeomTransformSetGeom(s.set().transform, sphere);
                 }});
    r.push_back({"dGeomTransformSetCleanup",
                 [](CallScene &s) { dGeomTransformSetCleanup(s.set().transform, 0); },
                 [](CallScene &s) { dGeomTransformSetCleanup(s.set().transform, 1); }});
    r.push_back({"dGeomTransformSetInfo", [](CallScene &s) { dGeomTransformSetInfo(s.set().transform, 1); },
                 [](CallScene &s) { dGeomTransformSetInfo(s.set().transform, 0); }});
}

void addGetters(CallRecipes &r) {
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    ask("dGeomSphereGetRadius", [](CallScene &s) { s.tell(dGeomSphereGetRadius(s.set().sphere)); });
    ask("dGeomSpherePointDepth",
        [](CallScene &s) { s.tell(dGeomSpherePointDepth(s.set().sphere, 0.1, 0, 0.3)); });
    ask("dGeomBoxGetLengths", [](CallScene &s) {
        dVector3 lengths;
        dGeomBoxGetLengths(s.set().box, lengths);
        s.tell(lengths, 3);
    });
    ask("dGeomBoxPointDepth", [](CallScene &s) { s.tell(dGeomBoxPointDepth(s.set().box, 0.1, 0, 0.3)); });
    ask("dGeomPlaneGetParams", [](CallScene &s) {
        dVector4 params;
        dGeomPlaneGetParams(s.set().plane, params);
        s.tell(params, 4);
    });
    ask("dGeomPlanePointDepth",
        [](CallScene &s) { s.tell(dGeomPlanePointDepth(s.set().plane, 0.1, 0, 0.3)); });
    ask("dGeomCapsuleGetParams", [](CallScene &s) {
        dReal radius, length;
        dGeomCapsuleGetParams(s.set().capsule, &radius, &length);
        s.tell(radius + length);
    });
    ask("dGeomCapsulePointDepth",
        [](CallScene &s) { s.tell(dGeomCapsulePointDepth(s.set().capsule, 0.1, 0, 0.3)); });
    ask("dGeomCylinderGetParams", [](CallScene &s) {
        dReal radius, length;
        dGeomCylinderGetParams(s.set().cylinder, &radius, &length);
        s.tell(radius + length);
    });
    ask("dGeomRayGetLength", [](CallScene &s) { s.tell(dGeomRayGetLength(s.set().ray)); });
    ask("dGeomRayGet", [](CallScene &s) {
        dVector3 start, direction;
        dGeomRayGet(s.set().ray, start, direction);
        s.tell(start, 3);
        s.tell(direction, 3);
    });
    ask("dGeomRayGetParams", [](CallScene &s) {
        int first, cull;
        dGeomRayGetParams(s.set().ray, &first, &cull);
        s.tell(2 * first + cull);
    });
    ask("dGeomRayGetFirstContact", [](CallScene &s) { s.tell(dGeomRayGetFirstContact(s.set().ray)); });
    ask("dGeomRayGetBackfaceCull", [](CallScene &s) { s.tell(dGeomRayGetBackfaceCull(s.set().ray)); });
    ask("dGeomRayGetClosestHit", [](CallScene &s) { s.tell(dGeomRayGetClosestHit(s.set().ray)); });
    ask("dGeomTransformGetGeom",
        [](CallScene &s) { s.tell(static_cast<const void *>(dGeomTransformGetGeom(s.set().transform))); });
    ask("dGeomTransformGetCleanup",
        [](CallScene &s) { s.tell(dGeomTransformGetCleanup(s.set().transform)); });
    ask("dGeomTransformGetInfo", [](CallScene &s) { s.tell(dGeomTransformGetInfo(s.set().transform)); });
}

}  // namespace

void addShapeCalls(CallRecipes &recipes) {
    addCreators(recipes);
    addSetters(recipes);
    addGetters(recipes);
}

}  // namespace kept_state
