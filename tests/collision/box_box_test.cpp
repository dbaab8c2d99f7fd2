// Contacts of two boxes, bit for bit those of upstream's dBoxBox, as Debian built it: on every instruction set, in every mode of
// rounding, for boxes at random, on a grid, stacked, crossed, flat, endless, tiny, huge, sheared and not numbers.
//
// Covers dxBoxContacts.cpp.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <cfenv>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "DebianOde.h"
#include "instruction_sets.h"
#include "seams/upstream.h"
#include "threading/dxFloatEnvironment.h"

namespace {

constexpr int kMaxContacts = 12;

struct Box {
    dVector3 position, sides;
    dMatrix3 rotation;
};

struct Question {
    Box boxes[2];
    int flags;
};

struct Answer {
    int count, code;
    bool isAsserted;
    dReal normal[4], depth;
    dContactGeom contacts[kMaxContacts];
};

std::jmp_buf afterAssertion;
void leave(int, const char *, va_list) { std::longjmp(afterAssertion, 1); }

Answer ask(decltype(&dBoxBox) boxBox, const Question &question) {
    Answer answer;
    std::memset(&answer, 0x5a, sizeof answer);
    const Box &a = question.boxes[0], &b = question.boxes[1];
    answer.isAsserted = setjmp(afterAssertion) != 0;
    if (!answer.isAsserted)
        answer.count = boxBox(a.position, a.rotation, a.sides, b.position, b.rotation, b.sides, answer.normal, &answer.depth,
                              &answer.code, question.flags, answer.contacts, sizeof(dContactGeom));
    return answer;
}

bool isSame(dReal a, dReal b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

// Of bytes that are not written both have the same pattern.
bool isSame(const Answer &a, const Answer &b) {
    if (a.isAsserted || b.isAsserted) return a.isAsserted == b.isAsserted;
    bool same = a.count == b.count && a.code == b.code && isSame(a.depth, b.depth);
    for (int k = 0; k < 4; ++k) same = same && isSame(a.normal[k], b.normal[k]);
    for (int i = 0; i < kMaxContacts; ++i) {
        for (int k = 0; k < 4; ++k) same = same && isSame(a.contacts[i].pos[k], b.contacts[i].pos[k]);
        same = same && isSame(a.contacts[i].depth, b.contacts[i].depth);
        same = same && std::memcmp(a.contacts[i].normal, b.contacts[i].normal, sizeof a.contacts[i].normal) == 0;
    }
    return same;
}

class BoxBox : public testing::Test {
protected:
    void SetUp() override {
        dInitODE2(0);
        dSetDebugHandler(leave);
        if (!debianOde::kSamePrecision) return;
        m_upstream = debianOde::function(&dBoxBox, "dBoxBox");
        debianOde::function(&dSetDebugHandler, "dSetDebugHandler")(leave);
    }
    void TearDown() override {
        if (debianOde::kSamePrecision) debianOde::function(&dSetDebugHandler, "dSetDebugHandler")(nullptr);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }

    // On every instruction set. Returns how many had contacts.
    int compare(int questions, const std::function<Question()> &next) {
        int touching = 0;
        for (const std::int64_t set : instructionSets()) {
            m_random.seed(7);
            touching = 0;
            onInstructionSet(set, [&] {
                for (int i = 0; i < questions && !HasFailure(); ++i) {
                    const Question question = next();
                    const Answer expected = ask(m_upstream, question), actual = ask(&dBoxBox, question);
                    EXPECT_TRUE(isSame(expected, actual)) << "question " << i << ": " << expected.count << " contacts, code "
                                                          << expected.code << "; ours " << actual.count << ", " << actual.code;
                    touching += !expected.isAsserted && expected.count > 0;
                }
            });
        }
        return touching;
    }

    dReal between(dReal low, dReal high) { return low + (high - low) * dReal(m_random()) / dReal(m_random.max()); }
    int oneOf(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    Box upright(dReal x, dReal y, dReal z, dReal side) {
        Box box{{x, y, z, 0}, {side, side, side, 0}, {}};
        dRSetIdentity(box.rotation);
        return box;
    }
    // What is behind three numbers is not read.
    Box turned(Box box) {
        dRFromAxisAndAngle(box.rotation, between(-1, 1), between(-1, 1), between(-1, 1), between(0, 7));
        for (dReal *const vector : {box.position, box.sides, box.rotation, box.rotation + 4, box.rotation + 8})
            vector[3] = std::numeric_limits<dReal>::quiet_NaN();
        return box;
    }
    Box random(dReal spread) {
        Box box = turned(upright(between(-spread, spread), between(-spread, spread), between(-spread, spread), 1));
        for (int k = 0; k < 3; ++k) box.sides[k] = between(dReal(0.2), 2);
        return box;
    }
    // Many of these touch without overlap, are parallel, or have their centres in one place.
    Box onGrid() {
        Box box = upright(dReal(oneOf(5) - 2) / 2, dReal(oneOf(5) - 2) / 2, dReal(oneOf(5) - 2) / 2, 1);
        for (int k = 0; k < 3; ++k) box.sides[k] = dReal(oneOf(4)) / 2;
        const int axis = oneOf(3);
        if (oneOf(2) == 0) dRFromAxisAndAngle(box.rotation, axis == 0, axis == 1, axis == 2, dReal(oneOf(8)) * dReal(M_PI / 4));
        return box;
    }
    Question stacked() {
        Question question{{upright(0, 0, 0, 1), upright(0, 0, 0, 1)}, flags()};
        for (Box &box : question.boxes) {
            dRFromAxisAndAngle(box.rotation, between(-1, 1) * dReal(1e-3), between(-1, 1) * dReal(1e-3), 1, between(-1, 1) * kTurns[oneOf(3)]);
            for (int k = 0; k < 2; ++k) box.position[k] = between(-1, 1) * dReal(0.2) * dReal(oneOf(2));
        }
        question.boxes[oneOf(2)].position[2] = between(dReal(0.99), dReal(1.001));
        return question;
    }
    int flags() { return oneOf(4) == 0 ? 1 + oneOf(9) : kMaxContacts; }

    static constexpr dReal kTurns[3] = {0, dReal(0.01), 3};
    std::mt19937 m_random;
    decltype(&dBoxBox) m_upstream = &dxUpstreamBoxBox;
};

TEST_F(BoxBox, AtRandom) {
    EXPECT_GT(compare(100000, [&] { return Question{{random(1), random(1)}, flags()}; }), 20000);
}

TEST_F(BoxBox, OnAGrid) {
    EXPECT_GT(compare(100000, [&] { return Question{{onGrid(), onGrid()}, flags()}; }), 10000);
}

TEST_F(BoxBox, Stacked) {
    EXPECT_GT(compare(100000, [&] { return stacked(); }), 50000);
}

// Where one contact is enough upstream takes the first axis that does not separate.
TEST_F(BoxBox, WithUnimportantContacts) {
    EXPECT_GT(compare(20000, [&] { return Question{{random(1), onGrid()}, (1 + oneOf(4)) | static_cast<int>(CONTACTS_UNIMPORTANT)}; }), 5000);
}

// One or more numbers of a pair are of an unusual kind.
TEST_F(BoxBox, OfUnusualNumbers) {
    using Limits = std::numeric_limits<dReal>;
    const dReal unusual[] = {0, -dReal(0), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min(), Limits::min(),
                             Limits::max(), Limits::epsilon(), std::sqrt(Limits::min()), std::sqrt(Limits::max()), -1, 2};
    const int kinds = static_cast<int>(sizeof unusual / sizeof unusual[0]);
    compare(150000, [&] {
        Question question{{oneOf(2) == 0 ? random(1) : onGrid(), oneOf(2) == 0 ? random(1) : onGrid()}, flags()};
        if (oneOf(4) == 0) question = stacked();
        for (int changes = 1 + oneOf(3); changes != 0; --changes) {
            Box &box = question.boxes[oneOf(2)];
            dReal *const places[] = {box.position, box.sides, box.rotation, box.rotation + 4, box.rotation + 8};
            places[oneOf(5)][oneOf(3)] = unusual[oneOf(kinds)];
        }
        return question;
    });
}

// All lengths of a pair are as small or as large as numbers can be.
TEST_F(BoxBox, OfAllSizes) {
    const int range = std::numeric_limits<dReal>::max_exponent;
    EXPECT_GT(compare(50000, [&] {
        Question question = oneOf(2) == 0 ? stacked() : Question{{random(1), random(1)}, flags()};
        const int exponent = oneOf(2 * range) - range;
        for (Box &box : question.boxes)
            for (int k = 0; k < 3; ++k) {
                box.position[k] = std::ldexp(box.position[k], exponent);
                box.sides[k] = std::ldexp(box.sides[k], exponent);
            }
        return question;
    }), 20000);
}

TEST_F(BoxBox, InEveryModeOfRounding) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        compare(10000, [&] { return oneOf(2) == 0 ? stacked() : Question{{onGrid(), random(1)}, flags()}; });
        std::fesetround(FE_TONEAREST);
    }
}

#ifdef __SSE2__
TEST_F(BoxBox, WithoutSmallNumbers) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);  // denormals are zero, as operands and as results
    compare(20000, [&] { return stacked(); });
    _mm_setcsr(before);
}
#endif

// Axes are tested that upstream does not reach, and quotients are taken in lanes that are not used.
TEST_F(BoxBox, RaisesNoErrorsOfItsOwn) {
    constexpr int kErrors = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    const auto raised = [](decltype(&dBoxBox) boxBox, const Question &question) {
        std::feclearexcept(FE_ALL_EXCEPT);
        ask(boxBox, question);
        return std::fetestexcept(kErrors);
    };
    m_random.seed(3);
    for (int i = 0; i < 20000; ++i) {
        const Question question = i % 2 == 0 ? stacked() : Question{{onGrid(), onGrid()}, flags()};
        EXPECT_EQ(raised(m_upstream, question), raised(&dBoxBox, question));
    }
}

// The squares of such lengths would overflow.
TEST_F(BoxBox, SendsNoSignalOfItsOwn) {
    const dReal length = 4 * std::sqrt(std::numeric_limits<dReal>::max());
    Question question{{upright(0, 0, 0, length), upright(length / 2, length / 2, length / 2, length)}, kMaxContacts};
    dRFromAxisAndAngle(question.boxes[1].rotation, 1, 2, 3, 1);
    const Answer expected = ask(m_upstream, question);
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO);
    const Answer actual = ask(&dBoxBox, question);
    fedisableexcept(FE_ALL_EXCEPT);
    EXPECT_GT(expected.count, 0);
    EXPECT_TRUE(isSame(expected, actual));
}

}  // namespace
