// Processes that a program has left running: they are this process's children when their own parent has ended, also those that
// lead a session or process group of their own (setsid, setpgid).
//
// Only children are signalled, whose numbers cannot be another process's before they are waited for; what these leave comes to this
// process in turn.
#pragma once

#include <chrono>
#include <functional>

namespace support {

// From then on what descends from this process becomes its child when its parent ends, and not that of the system's first process.
void adoptOrphans();

// Takes leave of children that have ended.
void reapOrphans();

struct EndedOrphans {
    bool wereThere = false;  // some were running
    bool areLeft = false;    // some are still: of another user, or they fork faster than they can be ended
};

// Ends all children, and theirs: by SIGTERM, and behind a second by SIGKILL; gives up after three more. `wait` passes a short time.
EndedOrphans endOrphans(const std::function<void(std::chrono::milliseconds)> &wait);

}  // namespace support
