// What kinds of events a timeline has: each is a constant, which a record names by its address.
#pragma once

#include "threading/timeline/dxFrameStage.h"

struct dxTimelineEvent {
    static constexpr unsigned kMaxArguments = 4;

    enum class Kind : unsigned char {
        Span,     // from one time to another, of a frame
        Idle,     // the same, between frames; without arguments
        Counter,  // its arguments are quantities of which each has a curve
    };

    const char *name;
    const char *category;                      // the room that it is in; a viewer filters by it
    const char *arguments[kMaxArguments] = {};  // names; null: none
    Kind kind = Kind::Span;
    dxFrameStage stage = dxFrameStage::None;  // of spans whose times are summed up
};
