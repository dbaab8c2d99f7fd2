// The library initialised for the length of a test, with the number of threads and the algorithm that the
// test wants; afterwards serial, automatic and closed again.
#pragma once

#include <ode/ode.h>

class OdeSession {
public:
    explicit OdeSession(int threads = 0, const char *algorithm = "auto") {
        dInitODE2(0);
        use(threads, algorithm);
    }
    ~OdeSession() {
        use(0, "auto");
        dCloseODE();
    }
    OdeSession(const OdeSession &) = delete;
    OdeSession &operator=(const OdeSession &) = delete;

    static void use(int threads, const char *algorithm) {
        dToggleODE_MT(threads);
        dODE_MT_SetAlgorithm(algorithm);
    }
};
