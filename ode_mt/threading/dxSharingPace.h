// Whether work that comes again and again, as the collisions of a space, is shared out to workers or stays on the calling
// thread: whichever of the two took less time of late.
//
// Both times are measured, of whole calls, with all that belongs to them. The way that is not in use is tried again from time
// to time, for a few calls in a row, of which the first is not counted: workers have to wake, caches to fill. A trial in
// vain makes the next one later; but if several calls in a row take longer than after the last trial, as in a scene that grows, it
// comes soon.
// What sharing costs more than working alone is taken from what it has saved. A debt is paid back by a small part of the time that is
// worked alone; until then sharing is not tried again. So where workers come late, because other programs have the processors, the
// loss is bounded however long a call takes that waits for them.
// It decides about speed alone; results are the same either way. One thread at a time.
#pragma once

class dxSharingPace {
public:
    // For the next call.
    bool shallShare() const;

    // How long the call took, and whether it was shared.
    void remember(bool shared, double ns);

private:
    struct Way {
        double ns = 0;    // of a call, fading; 0: never measured
        int fresh = 0;    // calls in a row
    };

    static constexpr int kShortestEarlyWait = 8;  // calls

    static double faded(const Way &way, double ns);
    bool isTimeForTrial(const Way &way) const;
    bool isEarly() const;
    bool isPaidBack() const;
    bool isTooDear() const;
    void account(bool shared, double ns);
    void judge();

    Way m_alone, m_shared;
    bool m_isSharing = false;  // the way in use; during a trial the other one
    bool m_isTrial = false;
    int m_calls = 0;           // since the last trial ended
    double m_judgedNs = 0;     // of the way in use, when it ended
    int m_wait = 0;            // calls between trials
    int m_earlyWait = kShortestEarlyWait;  // if they have become slower
    int m_slowCalls = 0;       // in a row, the last ones
    double m_savedNs = 0;      // by sharing; below zero: a debt
};
