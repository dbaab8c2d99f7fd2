// Recipes for the functions of collision_space.h.
#include "call_recipes.h"
#include "call_shapes.h"

namespace kept_state {

namespace {

// A geom leaves its space and is one of no space from then on, or the other way round.
void remove(dGeomID geom) {
    if (dGeomGetSpace(geom) == nullptr) return;
    dSpaceRemove(dGeomGetSpace(geom), geom);
}

dSpaceID spaceOf(CallScene &s) {
    return s.set().space != nullptr ? s.set().space : s.setAt(Place::root).space;
}

// The place's space, if it is a hash space, or else the root if that is one.
dSpaceID hashSpaceOf(CallScene &s) {
    const dSpaceID own = spaceOf(s), root = s.setAt(Place::root).space;
    if (dSpaceGetClass(own) == dHashSpaceClass) return own;
    return root != nullptr && dSpaceGetClass(root) == dHashSpaceClass ? root : nullptr;
}

void addTo(dSpaceID space, dGeomID geom) {
    if (dGeomGetSpace(geom) != nullptr) remove(geom);
    dSpaceAdd(space, geom);
}

void addFilled(CallScene &s, dSpaceID space) {
    s.adopt(dCreateSphere(space, 0.4));
    dGeomSetPosition(s.created(), 0.6, 0.5, 0.4);
    s.trace.know(space);
    if (s.set().space == nullptr) dSpaceDestroy(space), s.drop(s.created());
}

void destroyCreatedSpace(CallScene &s) {
    const dGeomID geom = s.created();
    if (geom == nullptr || s.set().space == nullptr) return;
    const dSpaceID space = dGeomGetSpace(geom);
    s.drop(geom);
    dSpaceDestroy(space);
}

// The whole space with all in it goes.
void destroySpace(CallScene &s) {
    GeomSet &set = s.set();
    if (set.space == nullptr) return;
    const dSpaceID space = set.space;
    if (s.place == Place::root) {
        s.setAt(Place::nested).space = nullptr;
        const std::vector<dGeomID> nested = s.setAt(Place::nested).all;
        for (const dGeomID geom : nested) s.drop(geom);
    }
    const std::vector<dGeomID> all = set.all;
    dSpaceDestroy(space);
    set.space = nullptr;
    for (const dGeomID geom : all) s.drop(geom);
}

void addMembership(CallRecipes &r) {
    r.push_back({"dSpaceAdd",
                 [](CallScene &s) { addTo(spaceOf(s), s.setAt(Place::nowhere).all[s.turn % 10 + 1]); },
                 [](CallScene &s) { remove(s.setAt(Place::nowhere).all[s.turn % 10 + 1]); }});
    r.push_back({"dSpaceRemove", [](CallScene &s) { remove(s.any()); },
                 [](CallScene &s) { addTo(spaceOf(s), s.any()); }});
    r.push_back({"dSpaceDestroy", destroySpace});
    r.back().inLocked = false;
    r.push_back({"dSpaceClean", [](CallScene &s) { dSpaceClean(spaceOf(s)); }});
    r.back().inCollision = false;
    r.push_back({"dSpaceGetGeom", [](CallScene &s) {
                     if (dSpaceGetClass(spaceOf(s)) == dQuadTreeSpaceClass) return;
                     for (int i = 0; i < dSpaceGetNumGeoms(spaceOf(s)); i += 2)
                         s.tell(static_cast<const void *>(dSpaceGetGeom(spaceOf(s), i)));
                 }});
}

void addCreators(CallRecipes &r) {
    r.push_back({"dSimpleSpaceCreate", [](CallScene &s) { addFilled(s, dSimpleSpaceCreate(s.set().space)); },
                 destroyCreatedSpace});
    r.back().inUserCode = false;
    r.push_back({"dHashSpaceCreate", [](CallScene &s) { addFilled(s, dHashSpaceCreate(s.set().space)); },
                 destroyCreatedSpace});
    r.back().inUserCode = false;
    r.push_back({"dSweepAndPruneSpaceCreate",
                 [](CallScene &s) { addFilled(s, dSweepAndPruneSpaceCreate(s.set().space, dSAP_AXES_ZXY)); },
                 destroyCreatedSpace});
    r.back().inUserCode = false;
    r.push_back({"dQuadTreeSpaceCreate",
                 [](CallScene &s) { addFilled(s, createSpace(SpaceKind::quadTree, s.set().space)); },
                 destroyCreatedSpace});
    r.back().inUserCode = false;
}

void addSettings(CallRecipes &r) {
    const auto ask = [&](const char *name, CallRecipe::Call call) {
        r.push_back({name, std::move(call), nullptr, true});
    };
    r.push_back({"dHashSpaceSetLevels",
                 [](CallScene &s) {
                     if (const dSpaceID space = hashSpaceOf(s)) dHashSpaceSetLevels(space, -1, 2);
                 },
                 [](CallScene &s) {
                     if (const dSpaceID space = hashSpaceOf(s)) dHashSpaceSetLevels(space, -3, 10);
                 }});
    ask("dHashSpaceGetLevels", [](CallScene &s) {
        if (dSpaceGetClass(spaceOf(s)) != dHashSpaceClass) return;
        int low, high;
        dHashSpaceGetLevels(spaceOf(s), &low, &high);
        s.tell(100 * high + low);
    });
    r.push_back({"dSpaceSetCleanup", [](CallScene &s) { dSpaceSetCleanup(spaceOf(s), 0); },
                 [](CallScene &s) { dSpaceSetCleanup(spaceOf(s), 1); }});
    ask("dSpaceGetCleanup", [](CallScene &s) { s.tell(dSpaceGetCleanup(spaceOf(s))); });
    r.push_back({"dSpaceSetSublevel", [](CallScene &s) { dSpaceSetSublevel(spaceOf(s), 2); },
                 [](CallScene &s) { dSpaceSetSublevel(spaceOf(s), 0); }});
    ask("dSpaceGetSublevel", [](CallScene &s) { s.tell(dSpaceGetSublevel(spaceOf(s))); });
    r.push_back({"dSpaceSetManualCleanup", [](CallScene &s) { dSpaceSetManualCleanup(spaceOf(s), 1); },
                 [](CallScene &s) { dSpaceSetManualCleanup(spaceOf(s), 0); }});
    ask("dSpaceGetManualCleanup", [](CallScene &s) { s.tell(dSpaceGetManualCleanup(spaceOf(s))); });
    ask("dSpaceQuery", [](CallScene &s) { s.tell(dSpaceQuery(spaceOf(s), s.any())); });
    ask("dSpaceGetNumGeoms", [](CallScene &s) { s.tell(dSpaceGetNumGeoms(spaceOf(s))); });
    ask("dSpaceGetClass", [](CallScene &s) { s.tell(dSpaceGetClass(spaceOf(s))); });
}

}  // namespace

void addSpaceCalls(CallRecipes &recipes) {
    CallRecipes r;
    addMembership(r);
    addCreators(r);
    addSettings(r);
    for (CallRecipe &recipe : r) {
        recipe.everySpace = !recipe.readsOnly;
        recipes.push_back(std::move(recipe));
    }
}

}  // namespace kept_state
