// Prints what RandomSpace reports, a line for each collision: pair_sequence SEED KIND GEOMS FRAMES BREATHES.
// pair_order_test runs it on Debian's libode8 and on ours.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "random_space.h"

namespace {

collision::Kind kindNamed(const char *name) {
    if (std::strcmp(name, "quadtree") == 0) return collision::Kind::QuadTree;
    if (std::strcmp(name, "sweep") == 0) return collision::Kind::Sweep;
    return std::strcmp(name, "hash") == 0 ? collision::Kind::Hash : collision::Kind::Simple;
}

void print(const char *what, const std::vector<std::pair<int, int>> &pairs) {
    std::printf(" %s", what);
    for (const auto &[a, b] : pairs) std::printf(" %d-%d", a, b);
}

}  // namespace

int main(int argc, char **argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: pair_sequence SEED KIND GEOMS FRAMES BREATHES\n");
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOFBF, 1 << 20);  // reports are long
    dInitODE2(0);
    {
        const collision::Recipe recipe{static_cast<unsigned>(std::atoi(argv[1])), kindNamed(argv[2]),
                                       std::atoi(argv[3]), std::atoi(argv[4]),
                                       std::atoi(argv[5]) != 0};
        collision::RandomSpace space(recipe);
        for (int frame = 0; frame < recipe.frames; ++frame) {
            space.changeSomething(frame);
            std::printf("frame %d:", frame);
            print("met", space.collide());
            print("probes", space.probe());
            std::printf(" list");
            for (const int number : space.list()) std::printf(" %d", number);
            std::printf("\n");
        }
    }
    dCloseODE();
}
