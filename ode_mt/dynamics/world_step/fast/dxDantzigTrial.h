// Dantzig's algorithm as one that may fail: its forces are judged, and the problem is kept for another algorithm.
//
// They are no answer where the algorithm gives up ("LCP internal error, s <= 0"), where one of them is not finite, and where they leave a row by
// more than a part of the largest b of what it asks for (dxIsAnswer). Large forces alone do not show that they are none: a chain with a heavy load
// has large ones, and rows that repeat one another may have any. Small ones do show that they are some: a residual is rounding of sums, so
// it is not computed where no force is larger than kMaxSmallSum times what the largest b could ask of its row.
//
// A friction row is judged without its limit, which is not known here: a force of either sign may be at a limit, and none may mean that there
// is no normal force.
//
// Threading: one thread. Messages of the algorithm are the caller's to hold back (dxHeldMessage).
#pragma once

#include <cstddef>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "threading/dxUpstreamScope.h"

struct dxIslandStep;

// The message of an algorithm that is asked for help. It is held back until nothing is held that the user's handler could strand with longjmp
// (pooled solvers, arenas), or until it is known that the algorithm's answer is not used.
//
// Threading: one thread, which does nothing else that draws random numbers or moves bodies meanwhile.
class dxHeldMessage final : public dxUpstreamScope {
public:
    // Messages are held; errors end the scope, and are handled as without it.
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override;
    std::uint32_t takeBlock(std::uint64_t draws) override;
    bool defersMoved() const override;

    bool isHeld() const { return m_isHeld; }

    // Ends the scope. Tells the first message, if there was one.
    void deliver();

private:
    static constexpr unsigned kMaxLength = 256;  // upstream's solver has none half as long

    bool m_isHeld = false;
    int m_number = 0;
    char m_text[kMaxLength];
};

class dxDantzigTrial {
public:
    // Taken from the step's arena beside what dxDantzigSolver takes, and given back in the end.
    static std::size_t memory(std::size_t bodies, std::size_t rows);

    // Solves as dxDantzigSolver does. The step and the problem outlive it.
    dxDantzigTrial(const dxIslandStep &step, const dxWorldStepProblem &problem, const dxHeldMessage &message);
    ~dxDantzigTrial();
    dxDantzigTrial(const dxDantzigTrial &) = delete;
    dxDantzigTrial &operator=(const dxDantzigTrial &) = delete;

    bool isAnswer() const { return m_isAnswer; }

    // As it was.
    const dxWorldStepProblem &unsolved() const { return m_unsolved; }

private:
    void keepRows();
    void findSizes(const dReal *matrix);
    bool areForcesSmall() const;
    bool findIfAnswer() const;
    double findResidual(const dxBodyVector *motions, const double *forces) const;

    const dxIslandStep &m_step;
    const dxWorldStepProblem &m_problem;
    dxWorldStepProblem m_unsolved;
    void *const m_state;  // of the arena
    double *m_diagonal;   // J inv(M) J' + c, by row
    double m_largestB = 0;
    bool m_isAnswer = false;
};
