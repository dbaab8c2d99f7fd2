// The scenes whose steps are judged: those that all tests share (worlds/scenes), and some with what these lack.
#pragma once

#include "scenes/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace quality {

// As scenes::makeScene takes it, without a stepper, or a name of ownScenes(). Throws std::invalid_argument.
std::unique_ptr<scenes::Scene> makeJudgedScene(const std::string &name, scenes::Stepper stepper);

std::vector<scenes::SceneDescription> ownScenes();

}  // namespace quality
