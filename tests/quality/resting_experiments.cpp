// What should lie still: stacks, towers, walls, heaps.
#include "judged_scenes.h"
#include "observation.h"

#include <algorithm>

namespace quality {

namespace {

std::vector<Quantity> stackOfTen(const Stepping &stepping) {
    constexpr dReal kSide = REAL(0.5);  // m
    Lab lab(stepping.stepper);
    use(stepping, lab);
    lab.addGround();
    const std::vector<dBodyID> boxes = addTower(lab, {0, 0, kSide / 2}, 10, kSide, 25);
    run(lab, 100);
    const Places places(boxes);
    std::vector<Quantity> quantities = observeRest(lab, 0, 900);
    quantities.push_back({"largest drift", "m", places.largestMove(), 1e-3});
    quantities.push_back({"sag", "m", REAL(9.5) * kSide - dBodyGetPosition(boxes.back())[2], 5e-4});
    return quantities;
}

// Each stands by itself; the higher a tower, the more iterations it needs.
std::vector<Quantity> towers(const Stepping &stepping) {
    constexpr dReal kSide = REAL(0.5);  // m
    constexpr int kHeights[] = {2, 3, 5, 7, 10, 14, 20};
    Lab lab(stepping.stepper);
    use(stepping, lab);
    lab.addGround();
    std::vector<std::vector<dBodyID>> all;
    for (const int height : kHeights)
        all.push_back(addTower(lab, {12 * static_cast<dReal>(all.size()), 0, kSide / 2}, height, kSide, 25));
    run(lab, 500);
    double fallen = 0, sag = 0;
    for (const std::vector<dBodyID> &tower : all) {
        const double ideal = (static_cast<double>(tower.size()) - 0.5) * kSide, real = dBodyGetPosition(tower.back())[2];
        fallen += real < 0.9 * ideal;
        sag = std::max(sag, (ideal - real) / ideal);
    }
    return {
        {"fallen", "", fallen, 0}, {"largest sag", "of the height", sag, 1e-3}, {"kinetic energy", "J", kineticEnergy(lab.inventory().bodies), 1e-3}};
}

// Contacts correct most of their depth within a step, so a force of the last one may be much too large.
std::vector<Quantity> correctedColumns(const Stepping &stepping) {
    constexpr dReal kSide = REAL(0.2);  // m
    Lab lab(stepping.stepper);
    use(stepping, lab);
    lab.surfaceOfAll() = {};
    lab.surfaceOfAll().mode = dContactApprox1 | dContactSoftERP;
    lab.surfaceOfAll().mu = 1;
    lab.surfaceOfAll().soft_erp = REAL(0.8);
    lab.addGround();
    for (int i = 0; i < 8; ++i) addTower(lab, {3 * kSide * static_cast<dReal>(i), 0, kSide / 2}, 6, kSide, 8);
    const Places places(lab.inventory().bodies);
    run(lab, 1000);
    return {{"fallen", "boxes", static_cast<double>(places.countLower(kSide / 2)), 0},
            {"kinetic energy", "J", kineticEnergy(lab.inventory().bodies), 1e-3}};
}

std::vector<Quantity> shared(const Stepping &stepping, const std::string &scene, int settling, int watched) {
    const std::unique_ptr<scenes::Scene> made = makeJudgedScene(scene, stepping.stepper);
    use(stepping, *made);
    return observeRest(*made, settling, watched);
}

std::vector<Quantity> wall(const Stepping &stepping) { return shared(stepping, "wall:5", 100, 200); }
std::vector<Quantity> pile(const Stepping &stepping) { return shared(stepping, "pile:100", 400, 100); }
std::vector<Quantity> balls(const Stepping &stepping) { return shared(stepping, "spheres:100", 400, 100); }
std::vector<Quantity> hub(const Stepping &stepping) { return shared(stepping, "resting_hub", 50, 200); }
std::vector<Quantity> massRatio(const Stepping &stepping) { return shared(stepping, "mass_ratio", 50, 300); }
std::vector<Quantity> infiniteFriction(const Stepping &stepping) { return shared(stepping, "infinite_friction", 300, 100); }
std::vector<Quantity> fixedFriction(const Stepping &stepping) { return shared(stepping, "fixed_friction", 300, 100); }
std::vector<Quantity> fixedPairs(const Stepping &stepping) { return shared(stepping, "fixed_pairs", 600, 200); }
std::vector<Quantity> hardContacts(const Stepping &stepping) { return shared(stepping, "hard_contacts", 300, 100); }

}  // namespace

std::vector<Experiment> restingExperiments() {
    return {{"stack", "ten boxes, 1000 frames", stackOfTen},
            {"towers", "towers of 2 to 20 boxes", towers},
            {"corrected_columns", "eight columns of six boxes, erp 0.8", correctedColumns},
            {"wall", "five by five bricks", wall},
            {"pile", "100 boxes that have fallen into a heap", pile},
            {"balls", "100 balls poured into a box", balls},
            {"hub", "98 boxes on one kinematic body", hub},
            {"mass_ratio", "four boxes of 1 kg under one of 20 to 120 kg", massRatio},
            {"infinite_friction", "heap of 50 boxes that do not slide", infiniteFriction},
            {"fixed_friction", "heap of 50 boxes, friction without dContactApprox1", fixedFriction},
            {"hard_contacts", "heap of 50 boxes with the world's erp and cfm", hardContacts},
            {"fixed_pairs", "eight columns of six pairs of boxes on fixed joints", fixedPairs}};
}

}  // namespace quality
