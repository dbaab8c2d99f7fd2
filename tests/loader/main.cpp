#include <gtest/gtest.h>
#include <ode/ode.h>

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    dInitODE2(0);
    const int result = RUN_ALL_TESTS();
    dCloseODE();
    return result;
}
