// Prints what RandomSpace reports, a line for each collision: pair_sequence SEED HASH GEOMS FRAMES BREATHES.
// pair_order_test runs it on Debian's libode8 and on ours.
#include <cstdio>
#include <cstdlib>

#include "random_space.h"

int main(int argc, char **argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: pair_sequence SEED HASH GEOMS FRAMES BREATHES\n");
        return 2;
    }
    dInitODE2(0);
    {
        const collision::Recipe recipe{static_cast<unsigned>(std::atoi(argv[1])), std::atoi(argv[2]) != 0,
                                       std::atoi(argv[3]), std::atoi(argv[4]),
                                       std::atoi(argv[5]) != 0};
        collision::RandomSpace space(recipe);
        for (int frame = 0; frame < recipe.frames; ++frame) {
            space.changeSomething(frame);
            std::printf("frame %d:", frame);
            for (const auto &[a, b] : space.collide()) std::printf(" %d-%d", a, b);
            std::printf(" list");
            for (const int number : space.list()) std::printf(" %d", number);
            std::printf("\n");
        }
    }
    dCloseODE();
}
