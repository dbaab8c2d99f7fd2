// The makers of the scenes, one file each.
#pragma once

#include "scenes/scene_options.h"

#include <memory>

namespace scenes {

std::unique_ptr<Scene> makeChain(const SceneOptions &options);
std::unique_ptr<Scene> makeChurn(const SceneOptions &options);
std::unique_ptr<Scene> makeConvex(const SceneOptions &options);
std::unique_ptr<Scene> makeConvexPile(const SceneOptions &options);
std::unique_ptr<Scene> makeCrowd(const SceneOptions &options);
std::unique_ptr<Scene> makeHumanoids(const SceneOptions &options);
std::unique_ptr<Scene> makeJointGrid(const SceneOptions &options);
std::unique_ptr<Scene> makeJunkyard(const SceneOptions &options);
std::unique_ptr<Scene> makePile(const SceneOptions &options);
std::unique_ptr<Scene> makePyramid(const SceneOptions &options);
std::unique_ptr<Scene> makePyramids(const SceneOptions &options);
std::unique_ptr<Scene> makeRagdolls(const SceneOptions &options);
std::unique_ptr<Scene> makeRays(const SceneOptions &options);
std::unique_ptr<Scene> makeRover(const SceneOptions &options);
std::unique_ptr<Scene> makeSoccer(const SceneOptions &options);
std::unique_ptr<Scene> makeSpheres(const SceneOptions &options);
std::unique_ptr<Scene> makeStacks(const SceneOptions &options);
std::unique_ptr<Scene> makeThingsOnMesh(const SceneOptions &options);
std::unique_ptr<Scene> makeThingsOnHeightField(const SceneOptions &options);
std::unique_ptr<Scene> makeVehiclesOnMesh(const SceneOptions &options);
std::unique_ptr<Scene> makeVehiclesOnHeightField(const SceneOptions &options);
std::unique_ptr<Scene> makeWall(const SceneOptions &options);
std::unique_ptr<Scene> makeWalls(const SceneOptions &options);
std::unique_ptr<Scene> makeWasher(const SceneOptions &options);

// One scene as the user sees it.
struct CatalogueEntry {
    const char *name;
    const char *meaning;
    const char *sizeMeaning;  // what :N counts
    int defaultSize;
    int largestSize;
    Stepper stepper;  // unless a modifier says otherwise
    std::unique_ptr<Scene> (*make)(const SceneOptions &);
};

}  // namespace scenes
