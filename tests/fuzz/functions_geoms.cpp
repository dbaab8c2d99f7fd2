// Functions that scripts call: those for geoms.
#include "by_hand.h"

#include "call_shapes.h"

namespace fuzz {

void addGeomFunctions(std::vector<Function> &all) {
    FUZZ_MAKER(dCreateBox);
    FUZZ_MAKER(dCreateCapsule);
    FUZZ_MAKER(dCreateCylinder);
    FUZZ_MAKER(dCreateGeomTransform);
    FUZZ_MAKER(dCreateHeightfield);
    FUZZ_MAKER(dCreatePlane);
    FUZZ_MAKER(dCreateRay);
    FUZZ_MAKER(dCreateSphere);
    FUZZ_TYPED(dGeomBoxGetLengths);
    FUZZ_TYPED(dGeomBoxPointDepth);
    FUZZ_TYPED(dGeomBoxSetLengths);
    FUZZ_TYPED(dGeomCapsuleGetParams);
    FUZZ_TYPED(dGeomCapsulePointDepth);
    FUZZ_TYPED(dGeomCapsuleSetParams);
    FUZZ_TYPED(dGeomClearOffset);
    FUZZ_TYPED(dGeomCopyOffsetPosition);
    FUZZ_TYPED(dGeomCopyOffsetRotation);
    FUZZ_TYPED(dGeomCopyPosition);
    FUZZ_TYPED(dGeomCopyRotation);
    FUZZ_TYPED(dGeomCylinderGetParams);
    FUZZ_TYPED(dGeomCylinderSetParams);
    FUZZ_TYPED(dGeomDisable);
    FUZZ_TYPED(dGeomEnable);
    FUZZ_TYPED(dGeomGetAABB);
    FUZZ_TYPED(dGeomGetBody);
    FUZZ_TYPED(dGeomGetBodyNext);
    FUZZ_TYPED(dGeomGetCategoryBits);
    FUZZ_TYPED(dGeomGetClass);
    FUZZ_TYPED(dGeomGetCollideBits);
    FUZZ_TYPED(dGeomGetOffsetPosition);
    FUZZ_TYPED(dGeomGetOffsetQuaternion);
    FUZZ_TYPED(dGeomGetOffsetRotation);
    FUZZ_TYPED(dGeomGetPosRelPoint);
    FUZZ_TYPED(dGeomGetPosition);
    FUZZ_TYPED(dGeomGetQuaternion);
    FUZZ_TYPED(dGeomGetRelPointPos);
    FUZZ_TYPED(dGeomGetRotation);
    FUZZ_TYPED(dGeomGetSpace);
    FUZZ_TYPED(dGeomHeightfieldGetHeightfieldData);
    FUZZ_TYPED(dGeomHeightfieldSetHeightfieldData);
    FUZZ_TYPED(dGeomIsEnabled);
    FUZZ_TYPED(dGeomIsOffset);
    FUZZ_TYPED(dGeomIsSpace);
    FUZZ_TYPED(dGeomMoved);
    FUZZ_TYPED(dGeomPlaneGetParams);
    FUZZ_TYPED(dGeomPlanePointDepth);
    FUZZ_TYPED(dGeomPlaneSetParams);
    FUZZ_TYPED(dGeomRayGet);
    FUZZ_TYPED(dGeomRayGetBackfaceCull);
    FUZZ_TYPED(dGeomRayGetClosestHit);
    FUZZ_TYPED(dGeomRayGetFirstContact);
    FUZZ_TYPED(dGeomRayGetLength);
    FUZZ_TYPED(dGeomRaySet);
    FUZZ_TYPED(dGeomRaySetBackfaceCull);
    FUZZ_TYPED(dGeomRaySetClosestHit);
    FUZZ_TYPED(dGeomRaySetFirstContact);
    FUZZ_TYPED(dGeomRaySetLength);
    FUZZ_TYPED(dGeomRaySetParams);
    FUZZ_TYPED(dGeomSetBody);
    FUZZ_TYPED(dGeomSetCategoryBits);
    FUZZ_TYPED(dGeomSetCollideBits);
    FUZZ_TYPED(dGeomSetOffsetPosition);
    FUZZ_TYPED(dGeomSetOffsetQuaternion);
    FUZZ_TYPED(dGeomSetOffsetRotation);
    FUZZ_TYPED(dGeomSetOffsetWorldPosition);
    FUZZ_TYPED(dGeomSetOffsetWorldQuaternion);
    FUZZ_TYPED(dGeomSetOffsetWorldRotation);
    FUZZ_TYPED(dGeomSetPosition);
    FUZZ_TYPED(dGeomSetQuaternion);
    FUZZ_TYPED(dGeomSetRotation);
    FUZZ_TYPED(dGeomSphereGetRadius);
    FUZZ_TYPED(dGeomSpherePointDepth);
    FUZZ_TYPED(dGeomSphereSetRadius);
    FUZZ_TYPED(dGeomTransformGetCleanup);
    FUZZ_TYPED(dGeomTransformGetGeom);
    FUZZ_TYPED(dGeomTransformGetInfo);
    FUZZ_TYPED(dGeomTransformSetCleanup);
    FUZZ_TYPED(dGeomTransformSetInfo);
    FUZZ_TYPED(dGeomTriMeshClearTCCache);
    FUZZ_TYPED(dGeomTriMeshEnableTC);
    FUZZ_TYPED(dGeomTriMeshGetData);
    FUZZ_TYPED(dGeomTriMeshGetLastTransform);
    FUZZ_TYPED(dGeomTriMeshGetTriMeshDataID);
    FUZZ_TYPED(dGeomTriMeshGetTriangleCount);
    FUZZ_TYPED(dGeomTriMeshIsTCEnabled);
    FUZZ_TYPED(dGeomTriMeshSetData);
    FUZZ_TYPED(dGeomVectorFromWorld);
    FUZZ_TYPED(dGeomVectorToWorld);
    FUZZ_TYPED(dInfiniteAABB);

    byHand(all, "dGeomDestroy", {object(ObjectKind::geom)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto geom = get<dGeomID>(player, arguments[0]);
        if (geom == nullptr) return false;
        player.objects.forgetGeom(geom);
        dGeomDestroy(geom);
        return true;
    });
    // The inner geom is the transform's from then on.
    byHand(all, "dGeomTransformSetGeom", {object(ObjectKind::geom, dGeomTransformClass), object(ObjectKind::geom)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto outer = get<dGeomID>(player, arguments[0]), inner = get<dGeomID>(player, arguments[1]);
               const bool isFit = outer != nullptr && inner != nullptr && outer != inner && !dGeomIsSpace(inner) &&
                                  dGeomGetClass(inner) != dGeomTransformClass && dGeomGetClass(inner) != dPlaneClass &&
                                  dGeomGetSpace(inner) == nullptr && dGeomGetBody(inner) == nullptr;
               if (!isFit) return false;
               player.objects.forget(ObjectKind::geom, inner);
               dGeomTransformSetGeom(outer, inner);
               return true;
           });
    byHandMaker(all, "dGeomTriMeshDataBuildSimple", ObjectKind::meshData, {number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    player.adopt(ObjectKind::meshData, kept_state::createMeshData(whole(arguments[0]) & 1), result);
                    return true;
                });
    byHandMaker(all, "dGeomHeightfieldDataBuildDouble", ObjectKind::heightData, {number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    player.adopt(ObjectKind::heightData, kept_state::createHeights(whole(arguments[0]) & 1), result);
                    return true;
                });
    Parameter space = object(ObjectKind::space);
    space.kind = Parameter::Kind::nullableObject;
    byHandMaker(all, "dCreateTriMesh", ObjectKind::geom, {space, object(ObjectKind::meshData)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const auto data = get<dTriMeshDataID>(player, arguments[1]);
                    if (data == nullptr) return false;
                    player.adopt(ObjectKind::geom,
                                 dCreateTriMesh(get<dSpaceID>(player, arguments[0]), data, nullptr, nullptr, nullptr), result);
                    return true;
                });
    byHandMaker(all, "dCreateConvex", ObjectKind::geom, {space, number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const kept_state::ConvexArrays a = kept_state::convexArrays(whole(arguments[1]) & 1);
                    player.adopt(ObjectKind::geom,
                                 dCreateConvex(get<dSpaceID>(player, arguments[0]), a.planes, a.planeCount, a.points,
                                               a.pointCount, a.polygons),
                                 result);
                    return true;
                });
    byHand(all, "dGeomSetConvex", {object(ObjectKind::geom, dConvexClass), number(Meaning::flag)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto geom = get<dGeomID>(player, arguments[0]);
               if (geom == nullptr) return false;
               const kept_state::ConvexArrays a = kept_state::convexArrays(whole(arguments[1]) & 1);
               dGeomSetConvex(geom, a.planes, a.planeCount, a.points, a.pointCount, a.polygons);
               return true;
           });
    // Spheres of a class of the program's.
    byHandMaker(all, "dCreateGeom", ObjectKind::geom, {space, number(Meaning::size), number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const int which = whole(arguments[2]) & 1;
                    player.adopt(ObjectKind::geom,
                                 kept_state::createCustom(get<dSpaceID>(player, arguments[0]), real(arguments[1]),
                                                          which != 0 ? kept_state::testedClass() : kept_state::customClass()),
                                 result);
                    return true;
                });
}

}  // namespace fuzz
