#include <gtest/gtest.h>
#include <ode/ode.h>

// Read by LeakSanitizer, if there is one: Assimp does not free what it made of a damaged mesh file.
extern "C" const char *__lsan_default_suppressions() { return "leak:libassimp.so\n"; }

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    dInitODE2(0);
    const int result = RUN_ALL_TESTS();
    dCloseODE();
    return result;
}
