#include "questions.h"

namespace poses {

namespace {

constexpr int unimportant = static_cast<int>(CONTACTS_UNIMPORTANT);
constexpr int dense = sizeof(dContactGeom), spread = sizeof(dContact);

constexpr Question questions[] = {{64, dense},
                                  {1, dense},
                                  {8, spread},
                                  {2, dense},
                                  {3, spread},
                                  {64, dense},
                                  {8 | unimportant, dense},
                                  {4, dense},
                                  {16, spread},
                                  {1 | unimportant, spread},
                                  {200, dense}};
constexpr int questionCount = sizeof(questions) / sizeof(questions[0]);

// Pairs and questions for which upstream reads what was never written, or ends the process.
struct Exclusion {
    bool (*holds)(Kind one, Kind other, bool isUnimportant);
    const char *reason;
};

constexpr Exclusion exclusions[] = {
    {[](Kind one, Kind other, bool isUnimportant) {
         return isUnimportant && one == Kind::Convex && isMesh(other);
     },
     "an unset variable of the stack is handed out as the contact"},
};

}  // namespace

Question question(int number) { return questions[number % questionCount]; }

const char *noAnswerBecause(const PoseShape &one, const PoseShape &other, const Question &question) {
    const Kind first = one.solidKind(), second = other.solidKind();
    const bool isUnimportant = (question.flags & unimportant) != 0;
    for (const Exclusion &exclusion : exclusions) {
        if (exclusion.holds(first, second, isUnimportant) || exclusion.holds(second, first, isUnimportant))
            return exclusion.reason;
    }
    return nullptr;
}

}  // namespace poses
