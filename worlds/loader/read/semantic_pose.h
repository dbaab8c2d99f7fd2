// Poses as libsdformat resolves them.
#pragma once

#include "loader/load_error.h"

#include <ignition/math/Pose3.hh>
#include <sdf/SemanticPose.hh>

#include <string>

namespace worlds {

// `frame` empty: the frame that SDF takes for this kind of element (a link's is its model's). Throws
// LoadError.
inline ignition::math::Pose3d resolvePose(const sdf::SemanticPose &semantic, const Place &place,
                                          const std::string &frame = {}) {
    ignition::math::Pose3d pose;
    const sdf::Errors errors = semantic.Resolve(pose, frame);
    if (!errors.empty()) throw LoadError(LoadError::Kind::Value, place, errors.front().Message());
    return pose;
}

}  // namespace worlds
