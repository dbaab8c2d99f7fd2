// Functions that scripts call: those for worlds.
#include "by_hand.h"

#include <cstdio>
#include <cstdlib>
#include <regex>

namespace fuzz {

void addWorldFunctions(std::vector<Function> &all) {
    FUZZ_TYPED(dWorldCleanupWorkingMemory);
    FUZZ_TYPED(dWorldGetAngularDamping);
    FUZZ_TYPED(dWorldGetAngularDampingThreshold);
    FUZZ_TYPED(dWorldGetAutoDisableAngularThreshold);
    FUZZ_TYPED(dWorldGetAutoDisableAverageSamplesCount);
    FUZZ_TYPED(dWorldGetAutoDisableFlag);
    FUZZ_TYPED(dWorldGetAutoDisableLinearThreshold);
    FUZZ_TYPED(dWorldGetAutoDisableSteps);
    FUZZ_TYPED(dWorldGetAutoDisableTime);
    FUZZ_TYPED(dWorldGetCFM);
    FUZZ_TYPED(dWorldGetContactMaxCorrectingVel);
    FUZZ_TYPED(dWorldGetContactSurfaceLayer);
    FUZZ_TYPED(dWorldGetERP);
    FUZZ_TYPED(dWorldGetGravity);
    FUZZ_TYPED(dWorldGetLinearDamping);
    FUZZ_TYPED(dWorldGetLinearDampingThreshold);
    FUZZ_TYPED(dWorldGetMaxAngularSpeed);
    FUZZ_TYPED(dWorldGetQuickStepNumIterations);
    FUZZ_TYPED(dWorldGetQuickStepW);
    FUZZ_TYPED(dWorldGetStepIslandsProcessingMaxThreadCount);
    FUZZ_TYPED(dWorldSetAngularDamping);
    FUZZ_TYPED(dWorldSetAngularDampingThreshold);
    FUZZ_TYPED(dWorldSetAutoDisableAngularThreshold);
    FUZZ_TYPED(dWorldSetAutoDisableAverageSamplesCount);
    FUZZ_TYPED(dWorldSetAutoDisableFlag);
    FUZZ_TYPED(dWorldSetAutoDisableLinearThreshold);
    FUZZ_TYPED(dWorldSetAutoDisableSteps);
    FUZZ_TYPED(dWorldSetAutoDisableTime);
    FUZZ_TYPED(dWorldSetCFM);
    FUZZ_TYPED(dWorldSetContactMaxCorrectingVel);
    FUZZ_TYPED(dWorldSetContactSurfaceLayer);
    FUZZ_TYPED(dWorldSetDamping);
    FUZZ_TYPED(dWorldSetERP);
    FUZZ_TYPED(dWorldSetGravity);
    FUZZ_TYPED(dWorldSetLinearDamping);
    FUZZ_TYPED(dWorldSetLinearDampingThreshold);
    FUZZ_TYPED(dWorldSetMaxAngularSpeed);
    FUZZ_TYPED(dWorldSetQuickStepNumIterations);
    FUZZ_TYPED(dWorldSetQuickStepW);
    FUZZ_TYPED(dWorldSetStepIslandsProcessingMaxThreadCount);

    byHandMaker(all, "dWorldCreate", ObjectKind::world, {}, [](Player &player, const Arguments &, Reference &result) {
        player.adopt(ObjectKind::world, dWorldCreate(), result);
        return true;
    }, 1);
    byHand(all, "dWorldDestroy", {object(ObjectKind::world)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto world = get<dWorldID>(player, arguments[0]);
        if (world == nullptr) return false;
        player.emptyContacts();
        player.objects.forgetWorld(world);
        dWorldDestroy(world);
        return true;
    }, 1);
    // A world does not share memory with itself: upstream then uses memory that it has freed.
    byHand(all, "dWorldUseSharedWorkingMemory", {object(ObjectKind::world), object(ObjectKind::world)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]), other = get<dWorldID>(player, arguments[1]);
               if (world == nullptr || other == nullptr || world == other) return false;
               const double done = dWorldUseSharedWorkingMemory(world, other);
               player.tell("returns", &done, 1);
               return true;
           });
    for (const bool quick : {false, true})
        byHand(all, quick ? "dWorldQuickStep" : "dWorldStep", {object(ObjectKind::world), number(Meaning::time)},
               [quick](Player &player, const Arguments &arguments, Reference &) {
                   const auto world = get<dWorldID>(player, arguments[0]);
                   if (world == nullptr) return false;
                   player.step(world, real(arguments[1]), quick);
                   return true;
               }, 20);
    addData<dWorldID>(all, ObjectKind::world, "dWorldSetData", dWorldSetData, "dWorldGetData", dWorldGetData);
    byHand(all, "dWorldImpulseToForce",
           {object(ObjectKind::world), number(Meaning::time), number(Meaning::speed), number(Meaning::speed), number(Meaning::speed)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]);
               if (world == nullptr) return false;
               dVector3 force;
               dWorldImpulseToForce(world, real(arguments[1]), real(arguments[2]), real(arguments[3]), real(arguments[4]), force);
               player.tell("gives", force, 3);
               return true;
           }, 1);
    byHand(all, "dWorldExportDIF", {object(ObjectKind::world)}, [](Player &player, const Arguments &arguments, Reference &) {
        const auto world = get<dWorldID>(player, arguments[0]);
        if (world == nullptr) return false;
        char *text = nullptr;
        std::size_t size = 0;
        std::FILE *const file = open_memstream(&text, &size);
        dWorldExportDIF(world, file, "world.");
        std::fclose(file);
        // The sign of a NaN is not compared.
        player.trace().word(std::regex_replace(std::string(text, size), std::regex("-nan"), "nan"));
        std::free(text);
        return true;
    }, 1);
    byHand(all, "dWorldSetStepMemoryReservationPolicy", {object(ObjectKind::world), number(Meaning::flag), number(Meaning::bits)},
           [](Player &player, const Arguments &arguments, Reference &) {
               const auto world = get<dWorldID>(player, arguments[0]);
               if (world == nullptr) return false;
               dWorldStepReserveInfo info{};
               info.struct_size = sizeof info;
               info.reserve_factor = 1.5f;
               info.reserve_minimum = static_cast<unsigned>(whole(arguments[2])) & 0xffff;
               const double done = dWorldSetStepMemoryReservationPolicy(world, whole(arguments[1]) != 0 ? &info : nullptr);
               player.tell("returns", &done, 1);
               return true;
           }, 1);
    byHand(all, "emptyContacts", {}, [](Player &player, const Arguments &, Reference &) {
        player.emptyContacts();
        return true;
    }, 30);
    FUZZ_TYPED(dRand);
    FUZZ_TYPED(dRandGetSeed);
    FUZZ_TYPED(dRandReal);
    byHand(all, "dRandInt", {number(Meaning::bits)}, [](Player &player, const Arguments &arguments, Reference &) {
        const double drawn = dRandInt(1 + (whole(arguments[0]) & 0xffff));
        player.tell("returns", &drawn, 1);
        return true;
    }, 1);
    byHand(all, "dRandSetSeed", {number(Meaning::bits)}, [](Player &, const Arguments &arguments, Reference &) {
        dRandSetSeed(static_cast<unsigned long>(whole(arguments[0])));
        return true;
    });
}

}  // namespace fuzz
