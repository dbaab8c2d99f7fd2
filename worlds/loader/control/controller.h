// Drives motors of a model, frame by frame. Open loop: it reads only joint positions.
#pragma once

namespace worlds {

class Controller {
public:
    virtual ~Controller() = default;

    // Before the step of frame `frame`; the first one is 0.
    virtual void update(long frame) = 0;
};

}  // namespace worlds
