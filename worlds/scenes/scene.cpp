#include "scenes/scene.h"

namespace scenes {

void Scene::frame() {
    control();
    collide();
    step();
    finish();
}

}  // namespace scenes
