// Recipes for the functions of collision.h that are for geoms of every class.
#include "call_recipes.h"
#include "call_shapes.h"

// Exported, and in no header.
extern "C" void dGeomMoved(dGeomID geom);
extern "C" dGeomID dGeomGetBodyNext(dGeomID geom);

namespace kept_state {

namespace {

const dReal *quarterTurn() {
    static const dMatrix3 matrix{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
    return matrix;
}

const dReal *eighthTurn() {
    static const dQuaternion turn{0.92387953251128674, 0.38268343236508978, 0, 0};
    return turn;
}

void addPoses(CallRecipes &r) {
    r.push_back({"dGeomSetPosition", [](CallScene &s) { dGeomSetPosition(s.placeable(), 0.5, 0.6, 0.35); },
                 [](CallScene &s) { dGeomSetPosition(s.placeable(), 5, 5, 5); }});
    r.push_back({"dGeomSetRotation", [](CallScene &s) { dGeomSetRotation(s.placeable(), quarterTurn()); }});
    r.push_back(
        {"dGeomSetQuaternion", [](CallScene &s) { dGeomSetQuaternion(s.placeable(), eighthTurn()); }});
    r.push_back({"dGeomSetOffsetPosition",
                 [](CallScene &s) { dGeomSetOffsetPosition(s.carried(), 0.1, 0, 0.3); },
                 [](CallScene &s) { dGeomClearOffset(s.carried()); }});
    r.push_back(
        {"dGeomSetOffsetRotation", [](CallScene &s) { dGeomSetOffsetRotation(s.carried(), quarterTurn()); }});
    r.push_back({"dGeomSetOffsetQuaternion",
                 [](CallScene &s) { dGeomSetOffsetQuaternion(s.carried(), eighthTurn()); }});
    r.push_back({"dGeomSetOffsetWorldPosition",
                 [](CallScene &s) { dGeomSetOffsetWorldPosition(s.carried(), 0.5, 0.6, 0.4); }});
    r.push_back({"dGeomSetOffsetWorldRotation",
                 [](CallScene &s) { dGeomSetOffsetWorldRotation(s.carried(), quarterTurn()); }});
    r.push_back({"dGeomSetOffsetWorldQuaternion",
                 [](CallScene &s) { dGeomSetOffsetWorldQuaternion(s.carried(), eighthTurn()); }});
    r.push_back({"dGeomClearOffset", [](CallScene &s) { dGeomClearOffset(s.carried()); },
                 [](CallScene &s) { dGeomSetOffsetPosition(s.carried(), 0.4, 0, 0); }});
}

void addQuestions(CallRecipes &r) {
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    ask("dGeomGetData", [](CallScene &s) { s.tell(dGeomGetData(s.any()) == nullptr); });
    ask("dGeomGetBody", [](CallScene &s) { s.tell(static_cast<const void *>(dGeomGetBody(s.any()))); });
    ask("dGeomGetPosition", [](CallScene &s) { s.tell(dGeomGetPosition(s.placeable()), 3); });
    ask("dGeomCopyPosition", [](CallScene &s) {
        dVector3 place;
        dGeomCopyPosition(s.placeable(), place);
        s.tell(place, 3);
    });
    ask("dGeomGetRotation", [](CallScene &s) { s.tell(dGeomGetRotation(s.placeable()), 3); });
    ask("dGeomCopyRotation", [](CallScene &s) {
        dMatrix3 rotation;
        dGeomCopyRotation(s.placeable(), rotation);
        s.tell(rotation, 3);
    });
    ask("dGeomGetQuaternion", [](CallScene &s) {
        dQuaternion turn;
        dGeomGetQuaternion(s.placeable(), turn);
        s.tell(turn, 4);
    });
    ask("dGeomGetAABB", [](CallScene &s) {
        dReal box[6];
        dGeomGetAABB(s.any(), box);
        s.tell(box, 6);
    });
    ask("dInfiniteAABB", [](CallScene &s) {
        dReal box[6];
        dInfiniteAABB(s.any(), box);
        s.tell(box, 6);
    });
    ask("dGeomIsSpace", [](CallScene &s) { s.tell(dGeomIsSpace(s.any())); });
    ask("dGeomGetSpace", [](CallScene &s) { s.tell(static_cast<const void *>(dGeomGetSpace(s.any()))); });
    ask("dGeomGetClass", [](CallScene &s) { s.tell(dGeomGetClass(s.any())); });
    ask("dGeomGetCategoryBits", [](CallScene &s) { s.tell(dGeomGetCategoryBits(s.any())); });
    ask("dGeomGetCollideBits", [](CallScene &s) { s.tell(dGeomGetCollideBits(s.any())); });
    ask("dGeomIsEnabled", [](CallScene &s) { s.tell(dGeomIsEnabled(s.any())); });
    ask("dGeomIsOffset", [](CallScene &s) { s.tell(dGeomIsOffset(s.any())); });
    ask("dGeomGetOffsetPosition", [](CallScene &s) { s.tell(dGeomGetOffsetPosition(s.any()), 3); });
    ask("dGeomCopyOffsetPosition", [](CallScene &s) {
        dVector3 place;
        dGeomCopyOffsetPosition(s.any(), place);
        s.tell(place, 3);
    });
    ask("dGeomGetOffsetRotation", [](CallScene &s) { s.tell(dGeomGetOffsetRotation(s.any()), 3); });
    ask("dGeomCopyOffsetRotation", [](CallScene &s) {
        dMatrix3 rotation;
        dGeomCopyOffsetRotation(s.any(), rotation);
        s.tell(rotation, 3);
    });
    ask("dGeomGetOffsetQuaternion", [](CallScene &s) {
        dQuaternion turn;
        dGeomGetOffsetQuaternion(s.any(), turn);
        s.tell(turn, 4);
    });
    using FromPoint = void (*)(dGeomID, dReal, dReal, dReal, dReal *);
    const auto askPoint = [&](const char *name, FromPoint function) {
        ask(name, [function](CallScene &s) {
            dVector3 result;
            function(s.placeable(), 0.1, 0.2, 0.3, result);
            s.tell(result, 3);
        });
    };
    askPoint("dGeomGetRelPointPos", dGeomGetRelPointPos);
    askPoint("dGeomGetPosRelPoint", dGeomGetPosRelPoint);
    askPoint("dGeomVectorToWorld", dGeomVectorToWorld);
    askPoint("dGeomVectorFromWorld", dGeomVectorFromWorld);
    ask("dGeomGetBodyNext",
        [](CallScene &s) { s.tell(static_cast<const void *>(dGeomGetBodyNext(s.carried()))); });
}

void tellPair(void *scene, dGeomID o1, dGeomID o2) {
    CallScene &s = *static_cast<CallScene *>(scene);
    s.tell(static_cast<const void *>(o1));
    s.tell(static_cast<const void *>(o2));
}

void addCollisions(CallRecipes &r) {
    r.push_back({"dCollide", [](CallScene &s) {
                     dContactGeom contacts[8]{};
                     for (const dGeomID other : s.set().all) {
                         const int count = dCollide(s.placeable(), other, 8, contacts, sizeof(dContactGeom));
                         s.tell(count);
                         for (int i = 0; i < count; ++i) s.tell(contacts[i].pos, 3);
                     }
                 }});
    r.back().inCollision = false;
    r.push_back({"dSpaceCollide", [](CallScene &s) {
                     if (s.set().space != nullptr) dSpaceCollide(s.set().space, &s, tellPair);
                 }});
    r.back().inCollision = false;
    r.push_back({"dSpaceCollide2", [](CallScene &s) {
                     const dGeomID one =
                         s.place == Place::nowhere ? s.placeable() : reinterpret_cast<dGeomID>(s.set().space);
                     if (const dSpaceID root = s.setAt(Place::root).space)
                         dSpaceCollide2(one, reinterpret_cast<dGeomID>(root), &s, tellPair);
                     dSpaceCollide2(s.setAt(Place::other).all[s.turn % 10], one, &s, tellPair);
                 }});
    r.back().inCollision = false;
    r.push_back({"dClosestLineSegmentPoints",
                 [](CallScene &s) {
                     const dVector3 a{0, 0, 0, 0}, b{1, 0, 0, 0}, c{0, 1, 1, 0}, d{1, -1, 1, 0};
                     dVector3 one, other;
                     dClosestLineSegmentPoints(a, b, c, d, one, other);
                     s.tell(one, 3);
                     s.tell(other, 3);
                 },
                 nullptr, true});
    r.push_back({"dBoxTouchesBox",
                 [](CallScene &s) {
                     const dVector3 sides{1, 1, 1, 0};
                     s.tell(dBoxTouchesBox(dGeomGetPosition(s.set().box), dGeomGetRotation(s.set().box),
                                           sides, dGeomGetPosition(s.set().slab),
                                           dGeomGetRotation(s.set().slab), sides));
                 },
                 nullptr, true});
    r.push_back({"dBoxBox",
                 [](CallScene &s) {
                     const dVector3 sides{1, 1, 1, 0};
                     dVector3 normal{};
                     dReal depth = 0;
                     int code = 0;
                     dContactGeom contacts[8]{};
                     s.tell(dBoxBox(dGeomGetPosition(s.set().box), dGeomGetRotation(s.set().box), sides,
                                    dGeomGetPosition(s.set().slab), dGeomGetRotation(s.set().slab), sides,
                                    normal, &depth, &code, 8, contacts, sizeof(dContactGeom)));
                     s.tell(normal, 3);
                     s.tell(depth);
                 },
                 nullptr, true});
}

int noContact(dGeomID, dGeomID, int, dContactGeom *, int) { return 0; }

}  // namespace

void addCollisionCalls(CallRecipes &r) {
    addPoses(r);
    addQuestions(r);
    addCollisions(r);
    r.push_back({"dGeomDestroy", [](CallScene &s) { dGeomDestroy(s.takeGeom()); },
                 [](CallScene &s) { s.adopt(dCreateSphere(s.set().space, 0.3)); }});
    r.back().inLocked = false;
    r.push_back({"dGeomSetData", [](CallScene &s) { dGeomSetData(s.any(), &s); }});
    r.push_back({"dGeomSetBody", [](CallScene &s) { dGeomSetBody(s.carried(), s.filler(3)); },
                 [](CallScene &s) { dGeomSetBody(s.carried(), nullptr); }});
    r.push_back({"dGeomSetCategoryBits", [](CallScene &s) { dGeomSetCategoryBits(s.any(), 2); },
                 [](CallScene &s) { dGeomSetCategoryBits(s.any(), ~0ul); }});
    r.push_back({"dGeomSetCollideBits",
                 [](CallScene &s) {
                     dGeomSetCollideBits(s.any(), 0);
                     dGeomSetCategoryBits(s.set().plane, 4);
                 },
                 [](CallScene &s) { dGeomSetCollideBits(s.any(), ~0ul); }});
    r.push_back({"dGeomEnable", [](CallScene &s) { dGeomEnable(s.any()); },
                 [](CallScene &s) { dGeomDisable(s.any()); }});
    r.push_back({"dGeomDisable", [](CallScene &s) { dGeomDisable(s.any()); },
                 [](CallScene &s) { dGeomEnable(s.any()); }});
    r.push_back({"dGeomLowLevelControl", [](CallScene &s) {
                     int size = sizeof(int), value = 0;
                     s.tell(dGeomLowLevelControl(s.set().convex, dGeomCommonControlClass,
                                                 dGeomCommonAnyControlCode, &value, &size));
                 }});
    r.push_back({"dCreateGeomClass", [](CallScene &s) {
                     static int number = 0;
                     const dGeomClass functions = customClassFunctions();
                     if (number++ < 2) s.tell(dCreateGeomClass(&functions));
                 }});
    r.push_back({"dCreateGeom", [](CallScene &s) { s.adopt(createCustom(s.set().space, 0.35, customClass())); },
                 [](CallScene &s) {
                     const dGeomID geom = s.created();
                     s.drop(geom);
                     dGeomDestroy(geom);
                 }});
    r.push_back({"dGeomGetClassData", [](CallScene &s) {
                     *static_cast<dReal *>(dGeomGetClassData(s.set().custom)) = 0.5;
                     s.tell(*static_cast<dReal *>(dGeomGetClassData(s.set().custom)));
                 }});
    r.push_back({"dSetColliderOverride", [](CallScene &s) {
                     dSetColliderOverride(s.turn % 2 == 0 ? dBoxClass : dSphereClass, dPlaneClass, noContact);
                 }});
    r.push_back({"dGeomMoved", [](CallScene &s) { dGeomMoved(s.any()); }});
}

}  // namespace kept_state
