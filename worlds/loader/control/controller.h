// Acts before each step: drives motors of a model, or pushes its links. Open loop: it reads the state of its own model only.
#pragma once

namespace worlds {

class Controller {
public:
    virtual ~Controller() = default;

    // Before the step of frame `frame`; the first one is 0.
    virtual void update(long frame) = 0;
};

}  // namespace worlds
