#pragma once

namespace worlds {

constexpr double kTurn = 2 * 3.14159265358979323846;  // rad

}  // namespace worlds
