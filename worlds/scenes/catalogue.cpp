// The catalogue of scenes, and how "name:size,modifier" is read.
#include "scenes/catalogue.h"

#include <charconv>
#include <map>
#include <stdexcept>

namespace scenes {

namespace {

const CatalogueEntry kCatalogue[] = {
    {"rover", "a skid-steered rover among N static obstacles", "obstacles", 20, 100'000, Stepper::World,
     makeRover},
    {"soccer", "N fields with a ball and six two-wheeled box robots each", "fields", 1, 10'000,
     Stepper::World, makeSoccer},
    {"humanoids", "N humanoids of 17 bodies and 16 motors each", "humanoids", 22, 10'000, Stepper::World,
     makeHumanoids},
    {"stacks", "N stacks of ten boxes, far apart", "stacks", 100, 100'000, Stepper::Quick, makeStacks},
    {"pile", "N boxes dropped on one another", "boxes", 1000, 1'000'000, Stepper::Quick, makePile},
    {"wall", "a wall of N by N bricks", "bricks a side", 10, 1000, Stepper::Quick, makeWall},
    {"walls", "sixteen walls of N by N bricks, far apart", "bricks a side", 6, 100, Stepper::Quick, makeWalls},
    {"spheres", "N balls poured into a box with four walls", "balls", 500, 1'000'000, Stepper::Quick,
     makeSpheres},
    {"chain", "a hanging chain of N links that swings", "links", 50, 100'000, Stepper::World, makeChain},
    {"ragdolls", "N ragdolls that fall on the ground", "ragdolls", 20, 10'000, Stepper::Quick, makeRagdolls},
    {"vehicles", "N buggies on hilly ground, a triangle mesh", "buggies", 10, 2500, Stepper::Quick,
     makeVehiclesOnMesh},
    {"vehicles_heightfield", "N buggies on hilly ground, a height field", "buggies", 10, 2500, Stepper::Quick,
     makeVehiclesOnHeightField},
    {"crowd", "N boxes that lie on the ground", "boxes", 2000, 1'000'000, Stepper::Quick, makeCrowd},
    {"churn", "the same; in every frame one goes and one comes", "boxes", 2000, 1'000'000, Stepper::Quick,
     makeChurn},
    {"mesh_terrain", "N things on hilly ground, a triangle mesh", "things", 2000, 100'000, Stepper::Quick,
     makeThingsOnMesh},
    {"heightfield_terrain", "N things on hilly ground, a height field", "things", 2000, 100'000,
     Stepper::Quick, makeThingsOnHeightField},
    {"convex", "N convex polyhedra and cylinders dropped on one another", "solids", 2000, 100'000,
     Stepper::Quick, makeConvex},
    {"pyramid", "Box3D's large_pyramid: a flat pyramid of cubes, N at its base", "cubes", 100, 1000, Stepper::Quick, makePyramid},
    {"pyramids", "Box3D's many_pyramids: 196 of them, N cubes at the base of each", "cubes", 10, 100, Stepper::Quick, makePyramids},
    {"joint_grid", "Box3D's joint_grid: a hanging net of N by N balls on ball joints", "balls a side", 100, 1000, Stepper::Quick, makeJointGrid},
    {"convex_pile", "Box3D's convex_pile: N layers of 64 convex rocks of 32 corners", "layers", 80, 10'000, Stepper::Quick, makeConvexPile},
    {"junkyard", "Box3D's junkyard: N layers of 441 convex rocks in a yard that a column sweeps", "layers", 24, 1000, Stepper::Quick,
     makeJunkyard},
    {"washer", "Box3D's washer: N by N by N cubes in a drum that turns", "cubes a side", 20, 28, Stepper::Quick, makeWasher},
    {"rays", "N rays of moving sensors cast among 5000 shapes", "rays", 10'000, 1'000'000, Stepper::Quick,
     makeRays},
};

enum class Says { Stepper, Space, Sleep };

struct Modifier {
    Says what;
    const char *name;
    const char *meaning;
    void (*apply)(SceneOptions &);
};

const Modifier kModifiers[] = {
    {Says::Stepper, "world", "step with dWorldStep", [](SceneOptions &o) { o.stepper = Stepper::World; }},
    {Says::Stepper, "quick", "step with dWorldQuickStep", [](SceneOptions &o) { o.stepper = Stepper::Quick; }},
    {Says::Space, "simple", "collide in a simple space", [](SceneOptions &o) { o.space = SpaceKind::Simple; }},
    {Says::Space, "hash", "collide in a hash space (the default)", [](SceneOptions &o) { o.space = SpaceKind::Hash; }},
    {Says::Space, "sap", "collide in a sweep-and-prune space",
     [](SceneOptions &o) { o.space = SpaceKind::SweepAndPrune; }},
    {Says::Space, "quadtree", "collide in a quad-tree space", [](SceneOptions &o) { o.space = SpaceKind::QuadTree; }},
    {Says::Sleep, "autodisable", "let bodies at rest fall asleep", [](SceneOptions &o) { o.autoDisable = true; }},
};

template <class Table>
std::string names(const Table &table) {
    std::string text;
    for (const auto &entry : table) text += (text.empty() ? "" : ", ") + std::string(entry.name);
    return text;
}

template <class Table>
auto find(const Table &table, const std::string &name) -> decltype(&table[0]) {
    for (const auto &entry : table)
        if (name == entry.name) return &entry;
    return nullptr;
}

int readSize(const std::string &text, const CatalogueEntry &entry) {
    int size = 0;
    const char *end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, size);
    if (error != std::errc() || stopped != end || size < 1 || size > entry.largestSize || text != std::to_string(size))
        throw std::invalid_argument("scene '" + std::string(entry.name) + "': size '" + text +
                                    "' is not a number of " + entry.sizeMeaning + " from 1 to " +
                                    std::to_string(entry.largestSize));
    return size;
}

using Said = std::map<Says, std::string>;

void applyModifier(const std::string &name, const std::string &description, Said &said, SceneOptions &options) {
    const Modifier *modifier = find(kModifiers, name);
    if (!modifier)
        throw std::invalid_argument("scene '" + description + "': unknown modifier '" + name +
                                    "'; known: " + names(kModifiers));
    const auto [before, isNew] = said.emplace(modifier->what, name);
    if (!isNew)
        throw std::invalid_argument("scene '" + description + "': '" + before->second + "' and '" + name +
                                    "' exclude one another");
    modifier->apply(options);
}

struct Choice {
    const CatalogueEntry *entry;
    SceneOptions options;
};

Choice read(const std::string &description) {
    const std::size_t comma = description.find(',');
    const std::string nameAndSize = description.substr(0, comma);
    const std::size_t colon = nameAndSize.find(':');
    const std::string name = nameAndSize.substr(0, colon);

    const CatalogueEntry *entry = find(kCatalogue, name);
    if (!entry) throw std::invalid_argument("unknown scene '" + name + "'; known: " + names(kCatalogue));

    SceneOptions options;
    options.stepper = entry->stepper;
    options.size = entry->defaultSize;
    if (colon != std::string::npos) options.size = readSize(nameAndSize.substr(colon + 1), *entry);
    Said said;
    for (std::size_t at = comma; at != std::string::npos;) {
        const std::size_t next = description.find(',', at + 1);
        const std::size_t length = next == std::string::npos ? next : next - at - 1;
        applyModifier(description.substr(at + 1, length), description, said, options);
        at = next;
    }
    return {entry, options};
}

}  // namespace

std::unique_ptr<Scene> makeScene(const std::string &description) {
    const Choice choice = read(description);
    return choice.entry->make(choice.options);
}

void checkScene(const std::string &description) { read(description); }

std::vector<SceneDescription> availableScenes() {
    std::vector<SceneDescription> list;
    for (const CatalogueEntry &entry : kCatalogue) {
        const std::string stepper = entry.stepper == Stepper::World ? "dWorldStep" : "dWorldQuickStep";
        list.push_back({entry.name, std::string(entry.meaning) + "; N = " +
                                        std::to_string(entry.defaultSize) + " unless given, " + stepper});
    }
    return list;
}

std::vector<SceneDescription> availableModifiers() {
    std::vector<SceneDescription> list;
    for (const Modifier &modifier : kModifiers) list.push_back({modifier.name, modifier.meaning});
    return list;
}

}  // namespace scenes
