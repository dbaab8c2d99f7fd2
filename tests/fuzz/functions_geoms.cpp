// Functions that scripts call: those for geoms.
#include "by_hand.h"

#include <algorithm>

namespace fuzz {

namespace {

void addMeshFunctions(std::vector<Function> &all) {
    using Builder = Shapes::Builder;
    constexpr std::pair<const char *, Builder> builders[] = {
        {"dGeomTriMeshDataBuildSimple", Builder::simple}, {"dGeomTriMeshDataBuildSimple1", Builder::simple1},
        {"dGeomTriMeshDataBuildSingle", Builder::single}, {"dGeomTriMeshDataBuildSingle1", Builder::single1},
        {"dGeomTriMeshDataBuildDouble", Builder::doubles}, {"dGeomTriMeshDataBuildDouble1", Builder::doubles1}};
    for (const auto &[name, kind] : builders) {
        const Builder builder = kind;
        byHandMaker(all, name, ObjectKind::meshData, {number(Meaning::choice), number(Meaning::size)},
                    [builder](Player &player, const Arguments &arguments, Reference &result) {
                        player.adopt(ObjectKind::meshData,
                                     player.shapes.makeMesh(builder, whole(arguments[0]) & 3, real(arguments[1])), result);
                        return true;
                    }, 2);
    }
    byHandMaker(all, "dCreateTriMesh", ObjectKind::geom, {nullable(ObjectKind::space), object(ObjectKind::meshData)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const auto data = get<dTriMeshDataID>(player, arguments[1]);
                    if (data == nullptr) return false;
                    const auto space = get<dSpaceID>(player, arguments[0]);
                    player.adopt(ObjectKind::geom, dCreateTriMesh(space, data, nullptr, nullptr, nullptr), result);
                    return true;
                });
    const auto withData = [&](const char *name, std::vector<Parameter> parameters, auto call, int weight) {
        parameters.insert(parameters.begin(), object(ObjectKind::meshData));
        byHand(all, name, std::move(parameters), [call](Player &player, const Arguments &arguments, Reference &) {
            const auto data = get<dTriMeshDataID>(player, arguments[0]);
            if (data == nullptr) return false;
            call(player, data, arguments);
            return true;
        }, weight);
    };
    // Not while a geom has it.
    byHand(all, "dGeomTriMeshDataDestroy", {object(ObjectKind::meshData)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto data = get<dTriMeshDataID>(player, arguments[0]);
        if (data == nullptr || player.objects.isInUse(data)) return false;
        player.objects.forget(ObjectKind::meshData, data);
        dGeomTriMeshDataDestroy(data);
        return true;
    });
    withData("dGeomTriMeshDataPreprocess2", {number(Meaning::bits)}, [](Player &player, dTriMeshDataID data, const Arguments &arguments) {
        player.shapes.preprocess(data, static_cast<unsigned>(whole(arguments[1])));
    }, 2);
    withData("dGeomTriMeshDataUpdate", {}, [](Player &, dTriMeshDataID data, const Arguments &) { dGeomTriMeshDataUpdate(data); }, 4);
    withData("writeVertex", {number(Meaning::bits), number(Meaning::choice), number(Meaning::place)},
             [](Player &player, dTriMeshDataID data, const Arguments &arguments) {
                 player.shapes.writeVertex(data, whole(arguments[1]), whole(arguments[2]), real(arguments[3]));
             }, 6);

    const auto withMesh = [&](const char *name, auto set) {
        byHand(all, name, {object(ObjectKind::geom, dTriMeshClass), number(Meaning::flag)},
               [set](Player &player, const Arguments &arguments, Reference &) {
                   const auto mesh = get<dGeomID>(player, arguments[0]);
                   if (mesh == nullptr) return false;
                   set(mesh, whole(arguments[1]) != 0);
                   return true;
               }, 2);
    };
    withMesh("dGeomTriMeshSetCallback", [](dGeomID mesh, bool on) { dGeomTriMeshSetCallback(mesh, on ? keepsEvenTriangles : nullptr); });
    withMesh("dGeomTriMeshSetArrayCallback", [](dGeomID mesh, bool on) { dGeomTriMeshSetArrayCallback(mesh, on ? seesTriangles : nullptr); });
    withMesh("dGeomTriMeshSetRayCallback",
             [](dGeomID mesh, bool on) { dGeomTriMeshSetRayCallback(mesh, on ? stopsRaysAtOddTriangles : nullptr); });
    withMesh("dGeomTriMeshSetTriMergeCallback",
             [](dGeomID mesh, bool on) { dGeomTriMeshSetTriMergeCallback(mesh, on ? mergesToTheFirst : nullptr); });
    withMesh("dGeomTriMeshSetLastTransform", [](dGeomID mesh, bool on) {
        const dMatrix4 transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, on ? 0.125 : 0, 0.25, 0.5, 1};
        dGeomTriMeshSetLastTransform(mesh, transform);
    });
    withMesh("dGeomLowLevelControl", [](dGeomID mesh, bool on) {
        int value = on ? dGeomColliderMergeContactsValue_Full : dGeomColliderMergeContactsValue_None, size = sizeof value;
        dGeomLowLevelControl(mesh, dGeomColliderControlClass, dGeomColliderSetMergeSphereContactsControlCode, &value, &size);
    });
    byHand(all, "dGeomTriMeshGetTriangle", {object(ObjectKind::geom, dTriMeshClass), number(Meaning::bits)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto mesh = get<dGeomID>(player, arguments[0]);
               const int count = mesh == nullptr ? 0 : dGeomTriMeshGetTriangleCount(mesh);
               if (count == 0) return false;
               const int triangle = static_cast<int>(static_cast<unsigned>(whole(arguments[1])) % static_cast<unsigned>(count));
               dVector3 corners[3];
               dGeomTriMeshGetTriangle(mesh, triangle, &corners[0], &corners[1], &corners[2]);
               for (const dVector3 &corner : corners) player.tell("gives", corner, 3);
               dVector3 point;
               dGeomTriMeshGetPoint(mesh, triangle, 0.25, 0.5, point);
               player.tell("gives", point, 3);
               return true;
           }, 1);
}

void addHeightFunctions(std::vector<Function> &all) {
    using Samples = Shapes::Samples;
    byHandMaker(all, "dGeomHeightfieldDataCreate", ObjectKind::heightData, {}, [](Player &player, const Arguments &, Reference &result) {
        const dHeightfieldDataID data = player.shapes.makeField();
        player.shapes.buildField(data, Samples::doubles, {true, false, 1, 0, 0.5});
        player.adopt(ObjectKind::heightData, data, result);
        return true;
    });
    constexpr std::pair<const char *, Samples> builders[] = {{"dGeomHeightfieldDataBuildByte", Samples::bytes},
                                                             {"dGeomHeightfieldDataBuildShort", Samples::shorts},
                                                             {"dGeomHeightfieldDataBuildSingle", Samples::floats},
                                                             {"dGeomHeightfieldDataBuildDouble", Samples::doubles},
                                                             {"dGeomHeightfieldDataBuildCallback", Samples::callback}};
    for (const auto &[name, kind] : builders) {
        const Samples samples = kind;
        byHand(all, name,
               {object(ObjectKind::heightData), number(Meaning::flag), number(Meaning::flag), number(Meaning::size),
                number(Meaning::place), number(Meaning::size)},
               [samples](Player &player, const Arguments &arguments, Reference &) {
                   const auto data = get<dHeightfieldDataID>(player, arguments[0]);
                   if (data == nullptr) return false;
                   player.shapes.buildField(data, samples,
                                            {whole(arguments[1]) != 0, whole(arguments[2]) != 0, real(arguments[3]), real(arguments[4]),
                                             real(arguments[5])});
                   return true;
               }, 2);
    }
    byHand(all, "dGeomHeightfieldDataSetBounds", {object(ObjectKind::heightData), number(Meaning::place), number(Meaning::place)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto data = get<dHeightfieldDataID>(player, arguments[0]);
               if (data == nullptr) return false;
               dGeomHeightfieldDataSetBounds(data, std::min(real(arguments[1]), real(arguments[2])),
                                             std::max(real(arguments[1]), real(arguments[2])));
               return true;
           });
    // Not while a geom has it.
    byHand(all, "dGeomHeightfieldDataDestroy", {object(ObjectKind::heightData)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto data = get<dHeightfieldDataID>(player, arguments[0]);
        if (data == nullptr || player.objects.isInUse(data)) return false;
        player.objects.forget(ObjectKind::heightData, data);
        dGeomHeightfieldDataDestroy(data);
        return true;
    });
    byHand(all, "writeHeight", {object(ObjectKind::heightData), number(Meaning::bits), number(Meaning::fraction)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto data = get<dHeightfieldDataID>(player, arguments[0]);
               if (data == nullptr) return false;
               player.shapes.writeHeight(data, whole(arguments[1]), real(arguments[2]));
               return true;
           }, 6);
}

void addConvexFunctions(std::vector<Function> &all) {
    byHandMaker(all, "dCreateConvex", ObjectKind::geom, {nullable(ObjectKind::space), number(Meaning::choice)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const auto space = get<dSpaceID>(player, arguments[0]);
                    player.adopt(ObjectKind::geom, player.shapes.makeConvex(space, whole(arguments[1]) & 7), result);
                    return true;
                });
    byHand(all, "dGeomSetConvex", {object(ObjectKind::geom, dConvexClass), number(Meaning::choice)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto geom = get<dGeomID>(player, arguments[0]);
               if (geom == nullptr) return false;
               player.shapes.setConvex(geom, whole(arguments[1]) & 7);
               return true;
           });
    byHand(all, "writeConvexPoint", {number(Meaning::choice), number(Meaning::choice), number(Meaning::choice), number(Meaning::place)},
           [](Player &player, const Arguments &arguments, Reference &) {
               player.shapes.writeConvexPoint(whole(arguments[0]) & 7, whole(arguments[1]) & 7, whole(arguments[2]) & 7, real(arguments[3]));
               return true;
           }, 1);
}

}  // namespace

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
               player.objects.pinData(inner);
               player.objects.forget(ObjectKind::geom, inner);
               dGeomTransformSetGeom(outer, inner);
               return true;
           });
    addMeshFunctions(all);
    addHeightFunctions(all);
    addConvexFunctions(all);
    // Balls of a class of the program's.
    byHandMaker(all, "dCreateGeom", ObjectKind::geom, {nullable(ObjectKind::space), number(Meaning::size), number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const auto space = get<dSpaceID>(player, arguments[0]);
                    player.adopt(ObjectKind::geom, player.shapes.makeBall(space, real(arguments[1]), whole(arguments[2]) != 0), result);
                    return true;
                });
    byHand(all, "dCollide", {object(ObjectKind::geom), object(ObjectKind::geom), number(Meaning::choice), number(Meaning::flag)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto a = get<dGeomID>(player, arguments[0]), b = get<dGeomID>(player, arguments[1]);
               if (a == nullptr || b == nullptr || dGeomIsSpace(a) || dGeomIsSpace(b)) return false;
               player.tellContacts(a, b, 1 + (whole(arguments[2]) & 7), whole(arguments[3]) != 0);
               return true;
           }, 8);
    byHand(all, "dGeomRayGetParams", {object(ObjectKind::geom, dRayClass)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto ray = get<dGeomID>(player, arguments[0]);
        if (ray == nullptr) return false;
        int first = 0, cull = 0;
        dGeomRayGetParams(ray, &first, &cull);
        const double values[] = {static_cast<double>(first), static_cast<double>(cull)};
        player.tell("gives", values, 2);
        return true;
    });
    addData<dGeomID>(all, ObjectKind::geom, "dGeomSetData", dGeomSetData, "dGeomGetData", dGeomGetData);
}

}  // namespace fuzz
