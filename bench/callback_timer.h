// Times the near-callbacks of all calls of dSpaceCollide in this program.
#pragma once

namespace bench {

// Off at first. Not while dSpaceCollide runs.
void setCallbackTiming(bool on);

struct CallbackTimes {
    double callbacks = 0;  // s, in callbacks, of all threads together
    double timing = 0;     // s, in reading the clock for them
};

// Times since the last call. Callbacks made by calls within a callback are part of that callback.
CallbackTimes takeCallbackTimes();

}  // namespace bench
