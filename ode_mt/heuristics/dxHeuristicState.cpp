#include "heuristics/dxHeuristicState.h"

bool dxMayFollow(dxHeuristicState from, dxHeuristicState to) {
    switch (to) {
        case dxHeuristicState::Init:
            return false;
        case dxHeuristicState::Reset:
            return true;
        case dxHeuristicState::Running:
            return from != dxHeuristicState::Running && from != dxHeuristicState::Stopped;
        case dxHeuristicState::Paused:
            return from == dxHeuristicState::Running;
        case dxHeuristicState::Stopped:
            return from != dxHeuristicState::Stopped;
    }
    return false;
}

const char *dxNameOf(dxHeuristicState state) {
    switch (state) {
        case dxHeuristicState::Init:
            return "init";
        case dxHeuristicState::Reset:
            return "reset";
        case dxHeuristicState::Running:
            return "running";
        case dxHeuristicState::Paused:
            return "paused";
        case dxHeuristicState::Stopped:
            return "stopped";
    }
    return "unknown";
}
