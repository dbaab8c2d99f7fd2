// Functions that scripts call: those for spaces.
#include "by_hand.h"

namespace fuzz {

void addSpaceFunctions(std::vector<Function> &all) {
    FUZZ_MAKER(dHashSpaceCreate);
    FUZZ_TYPED(dHashSpaceSetLevels);
    FUZZ_MAKER(dSimpleSpaceCreate);
    FUZZ_TYPED(dSpaceClean);
    FUZZ_TYPED(dSpaceGetClass);
    FUZZ_TYPED(dSpaceGetCleanup);
    FUZZ_TYPED(dSpaceGetGeom);
    FUZZ_TYPED(dSpaceGetManualCleanup);
    FUZZ_TYPED(dSpaceGetNumGeoms);
    FUZZ_TYPED(dSpaceGetSublevel);
    FUZZ_TYPED(dSpaceQuery);
    FUZZ_TYPED(dSpaceRemove);
    FUZZ_TYPED(dSpaceSetCleanup);
    FUZZ_TYPED(dSpaceSetManualCleanup);
    FUZZ_TYPED(dSpaceSetSublevel);

    byHand(all, "dSpaceDestroy", {object(ObjectKind::space)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto space = get<dSpaceID>(player, arguments[0]);
        if (space == nullptr) return false;
        player.objects.forgetSpace(space);
        dSpaceDestroy(space);
        return true;
    }, 1);
    // A space is not added to itself, or to one within it.
    byHand(all, "dSpaceAdd", {object(ObjectKind::space), object(ObjectKind::geom)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto space = get<dSpaceID>(player, arguments[0]);
               const auto geom = get<dGeomID>(player, arguments[1]);
               if (space == nullptr || geom == nullptr) return false;
               for (dSpaceID outer = space; outer != nullptr; outer = dGeomGetSpace(reinterpret_cast<dGeomID>(outer)))
                   if (reinterpret_cast<dGeomID>(outer) == geom) return false;
               dSpaceAdd(space, geom);
               return true;
           });
    const Parameter parent = nullable(ObjectKind::space);
    byHandMaker(all, "dQuadTreeSpaceCreate", ObjectKind::space,
                {parent, number(Meaning::place), number(Meaning::place), number(Meaning::size), number(Meaning::flag)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    const dReal extent = 4 * real(arguments[3]);
                    const dVector3 center{real(arguments[1]), real(arguments[2]), 0, 0}, extents{extent, extent, extent, 0};
                    player.adopt(ObjectKind::space,
                                 dQuadTreeSpaceCreate(get<dSpaceID>(player, arguments[0]), center, extents,
                                                      1 + (whole(arguments[4]) & 3)),
                                 result);
                    return true;
                });
    byHandMaker(all, "dSweepAndPruneSpaceCreate", ObjectKind::space, {parent, number(Meaning::choice)},
                [](Player &player, const Arguments &arguments, Reference &result) {
                    constexpr int axes[] = {dSAP_AXES_XYZ, dSAP_AXES_XZY, dSAP_AXES_YXZ, dSAP_AXES_YZX, dSAP_AXES_ZXY, dSAP_AXES_ZYX};
                    const int which = whole(arguments[1]);
                    player.adopt(ObjectKind::space,
                                 dSweepAndPruneSpaceCreate(get<dSpaceID>(player, arguments[0]), axes[which >= 0 ? which % 6 : 0]),
                                 result);
                    return true;
                });
    byHand(all, "dHashSpaceGetLevels", {object(ObjectKind::space)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto space = get<dSpaceID>(player, arguments[0]);
        if (space == nullptr || dSpaceGetClass(space) != dHashSpaceClass) return false;
        int least = 0, most = 0;
        dHashSpaceGetLevels(space, &least, &most);
        const double levels[] = {static_cast<double>(least), static_cast<double>(most)};
        player.tell("levels", levels, 2);
        return true;
    });
    byHand(all, "dSpaceCollide", {object(ObjectKind::space)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto space = get<dSpaceID>(player, arguments[0]);
        if (space == nullptr) return false;
        player.collide(space);
        return true;
    }, 40);
    byHand(all, "dSpaceCollide2", {object(ObjectKind::geom), object(ObjectKind::geom)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto a = get<dGeomID>(player, arguments[0]), b = get<dGeomID>(player, arguments[1]);
               if (a == nullptr || b == nullptr) return false;
               player.collide2(a, b);
               return true;
           }, 20);
    // The state of everything, with or without the boxes, which a query updates.
    byHand(all, "look", {number(Meaning::flag)}, [](Player &player, const Arguments &arguments, Reference &) {
        player.look(whole(arguments[0]) != 0);
        return true;
    }, 8);
    byHand(all, "setSurface",
           {number(Meaning::bits), number(Meaning::fraction), number(Meaning::fraction), number(Meaning::fraction),
            number(Meaning::fraction), number(Meaning::fraction), number(Meaning::choice), number(Meaning::flag)},
           [](Player &player, const Arguments &arguments, Reference &) {
               dSurfaceParameters &surface = player.surface.parameters;
               surface.mode = whole(arguments[0]) & 0xffff;
               surface.mu = surface.rho = 2 * real(arguments[1]);
               surface.mu2 = surface.rho2 = surface.rhoN = real(arguments[2]);
               surface.bounce = real(arguments[3]);
               surface.bounce_vel = real(arguments[4]);
               surface.soft_erp = surface.motion1 = surface.slip1 = real(arguments[5]);
               surface.soft_cfm = surface.motion2 = surface.slip2 = real(arguments[5]) / 8;
               surface.motionN = real(arguments[4]) / 4;
               player.surface.most = 1 + (whole(arguments[6]) & 7);
               player.surface.flags = whole(arguments[7]) != 0 ? static_cast<int>(CONTACTS_UNIMPORTANT) : 0;
               return true;
           });
}

}  // namespace fuzz
