// How contacts are asked for: numbers, importance and distance in memory.
#pragma once

#include "pose_shape.h"

namespace poses {

struct Question {
    int flags;  // of dCollide
    int skip;   // bytes from one contact to the next
};

// The nth of all; they come again and again.
Question question(int number);

// Why upstream has no answer that a comparison could hold; null: it has one.
const char *noAnswerBecause(const PoseShape &one, const PoseShape &other, const Question &question);

}  // namespace poses
