// Asks the libode.so.8 that the loader finds for the contacts of geoms of every two classes, in poses drawn.
//
//   odemt_poses               a line for every two classes: the number of poses, contacts and refusals, and a
//   hash of it all odemt_poses convex mesh   a line for every question asked about these two: what came back,
//   bit by bit
//
// The first line names the library.
#include "contact_text.h"
#include "pose_shape.h"
#include "questions.h"

#include <dlfcn.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>

namespace {

using namespace poses;

constexpr int posesOfPair = 16000;  // times 66 pairs: a million

std::string libraryInUse() {
    Dl_info info;
    return dladdr(dlsym(RTLD_DEFAULT, "dCollide"), &info) != 0 ? info.dli_fname : "none";
}

// FNV-1a, 64 bits.
class Hash {
public:
    void add(const std::string &text) {
        for (unsigned char byte : text) m_value = (m_value ^ byte) * 0x100000001b3u;
    }
    std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325u;
};

class Pair {
public:
    Pair(Kind one, Kind other, const Materials &materials, bool isVerbose)
        : m_kinds{one, other},
          m_materials(materials),
          m_isVerbose(isVerbose),
          m_dice(static_cast<std::uint64_t>(one) * 100 + static_cast<std::uint64_t>(other)) {}

    void run() {
        create();
        for (int pose = 0; pose < posesOfPair; ++pose) {
            const int round = pose % 4;  // both at random, one of the two, none
            m_one->draw(m_dice, (round & 1) != 0);
            m_other->draw(m_dice, (round & 2) != 0);
            ask(pose, *m_one, *m_other);
            ask(pose, *m_other, *m_one);
        }
        if (m_isVerbose) return;
        std::printf("%s %s %d poses, %ld answers with contacts, %ld refusals, %016llx\n", nameOf(m_kinds[0]),
                    nameOf(m_kinds[1]), posesOfPair, m_met, m_refused,
                    static_cast<unsigned long long>(m_hash.value()));
    }

private:
    void create() {
        m_one = std::make_unique<PoseShape>(m_kinds[0], m_materials);
        m_other = std::make_unique<PoseShape>(m_kinds[1], m_materials);
    }

    void ask(int pose, const PoseShape &one, const PoseShape &other) {
        const Question asked = question(pose / 4);
        if (noAnswerBecause(one, other, asked) != nullptr) return;
        const std::string answer = m_text.ask(one, other, asked);
        if (m_isVerbose)
            std::printf("%d %s %s %x: %s\n", pose, nameOf(one.solidKind()), nameOf(other.solidKind()),
                        asked.flags, answer.c_str());
        m_hash.add(answer);
        m_refused += m_text.gaveUp();
        m_met += !m_text.gaveUp() && answer != "0";
    }

    Kind m_kinds[2];
    const Materials &m_materials;
    bool m_isVerbose;
    exactness::Dice m_dice;
    std::unique_ptr<PoseShape> m_one, m_other;
    ContactText m_text;
    Hash m_hash;
    long m_met = 0, m_refused = 0;
};

bool isNamed(Kind one, Kind other, int count, char **names) {
    return count < 3 ||
           (std::strcmp(names[1], nameOf(one)) == 0 && std::strcmp(names[2], nameOf(other)) == 0);
}

}  // namespace

int main(int count, char **names) {
    std::printf("%s\n", libraryInUse().c_str());
    dInitODE2(0);
    {
        const Materials materials;
        for (Kind one : allKinds) {
            for (Kind other : allKinds) {
                if (other >= one && isNamed(one, other, count, names))
                    Pair(one, other, materials, count >= 3).run();
                std::fflush(stdout);
            }
        }
    }
    dCloseODE();
    return 0;
}
