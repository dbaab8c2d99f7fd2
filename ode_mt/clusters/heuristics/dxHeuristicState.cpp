#include "clusters/heuristics/dxHeuristicState.h"

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
