// Decides whether work that comes again and again, as the collisions of a space, is shared by workers or stays on the calling
// thread: whichever of the two took less time lately. The words are those of dxParallelPayoff.h.
//
// Both times are measured, of whole calls, with everything that belongs to them. If several calls in a row take longer than
// after the last probe, as in a scene that grows, the next probe comes early. A probe whose calls were slower than those before it
// is doubted: the scene may have grown during it. If the calls after it are even slower, it has paid.
//
// What shared calls cost more than calls alone is subtracted from what they have saved. A debt is paid back by a small part of the
// time of calls alone; until then there is no probe. So where workers come late, because other programs use the
// processors, the loss is bounded, no matter how long a call waits for them.
//
// Very short calls, which reading a clock would slow down, are timed only now and then.
//
// Calls of one kind may differ in how much work they do, as steps of worlds of different sizes. A caller that knows the amount of work of a call
// beforehand passes it, in any unit: ways are then compared by the time of a unit. Otherwise the work of each call is 1.
//
// The decision affects speed alone; results are the same either way.
//
// Threading: one thread at a time.
#pragma once

#include <mutex>

class dxSharingPolicy {
public:
    dxSharingPolicy() = default;

    // For work that is slow when it is first shared: a probe of sharing has `sharedProbe` calls, of which the first `sharedCold` are cold.
    dxSharingPolicy(int sharedProbe, int sharedCold) : m_shared{sharedProbe, sharedCold} {}

    // Returns whether the next call, with this amount of work, should be shared.
    bool shouldShare(double work = 1) const;

    // Returns whether the time of the next call, which is not shared, should be recorded. Must be called once a call.
    bool shouldTimeAlone();

    // Records how long the call took, and whether it was shared.
    void record(bool shared, double ns, double work = 1);

private:
    struct Way {
        int probe = 3, cold = 1;  // calls that make a probe, and the first of them that do not count
        double ns = 0;            // moving average of a unit of work; 0: never measured
        int callsInRow = 0;
    };

    static constexpr int kMinEarlyRetry = 8;  // calls

    void average(Way &way, double ns);
    bool isTimeForProbe(const Way &way) const;
    bool isEarly() const;
    bool isPaidBack() const;
    bool isDebtTooHigh() const;
    void account(bool shared, double ns);
    void judgeProbe(double ns);
    void beginUse(double ns);
    void endProbe(double ns);
    bool hasGrownSince(const Way &way) const;

    Way m_alone, m_shared;
    double m_work = 1;         // of the last call
    bool m_isSharing = false;  // the way in use; during a probe the other one
    bool m_isProbe = false;
    double m_doubtedNs = 0;    // per unit, of the last probe, which did not pay, until calls after it have been timed; 0: there is none
    int m_calls = 0;           // since the last probe ended
    double m_judgedNs = 0;     // per unit, of the way in use, when it ended
    int m_retryInterval = 0;   // calls
    int m_earlyRetryInterval = kMinEarlyRetry;  // if calls have become slower
    int m_slowCalls = 0;       // in a row, the last ones
    int m_untimedCalls = 0;    // still to come
    double m_savedNs = 0;      // by sharing; below zero: a debt
};

// A policy that all threads share. A call that finds it in use by another thread does without it: it is not shared, and its time is not recorded.
//
// Threading: any thread.
class dxProcessSharingPolicy {
public:
    dxProcessSharingPolicy() = default;
    dxProcessSharingPolicy(int sharedProbe, int sharedCold) : m_policy(sharedProbe, sharedCold) {}

    enum class Answer { Alone, Shared, InUse };

    Answer ask(double work);

    // Returns whether the next call of that much work should be shared; false if the policy was in use.
    bool record(bool shared, double ns, double work);

private:
    std::mutex m_mutex;
    dxSharingPolicy m_policy;
};
