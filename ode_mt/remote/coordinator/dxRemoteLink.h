// What the coordinator knows of one worker: whether it may be given problems, how fast it is, what it has to do, and when that should be back.
//
// A link is New until its worker has said hello, Measured in between, Open when it may be given problems, and Lost for ever when it
// disconnected, was refused, or sent what cannot be. An open link of which something is late gets nothing until all is back, and then not for
// a pause that doubles each time, up to ten seconds.
//
// A worker that has heard nothing for a second looks for messages less often (dxPollPause). The link knows when it was sent something last, so
// that a message which finds it asleep is expected later, and tells nothing of its speed.
//
// Only send() takes memory, and changes nothing where there is none.
//
// Units: times in ns of one clock, costs in ns of work in this process. Threading: under the lock of dxRemoteWorkers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <vector>

#include "remote/transport/dxPollPause.h"

// Problems that were sent in one message and are not back.
struct dxRemoteInFlight {
    std::uint64_t number;
    std::vector<std::uint64_t> problems;
    double cost;
    double transferNs;    // there and back, the worker's sleep included
    double sent;
    double expected = 0;  // when they should be back
    double deadline = 0;  // after which they are reclaimed
    bool isWithdrawn = false, isWithdrawalSent = false;
    bool meetsSleep = false;  // the worker may have been asleep
    bool isPatient = false;   // this process has nothing better to do: it waits for seconds
};

class dxRemoteLink {
public:
    enum class State { New, Measured, Open, Lost };

    State state() const { return m_state; }
    bool isLate() const { return m_isLate; }
    // Has been late for so long that it had better be replaced, if that is possible.
    bool isGone(double now) const;
    // Has answered often.
    bool hasProved() const { return m_answers >= kOnTimeToForget; }

    // May be given problems now.
    bool isFree(double now) const;
    // Will be given some when what it has to do is back in time.
    bool isIdle(double now) const { return isUsable(now) && m_inFlight.empty(); }
    bool isUsable(double now) const { return m_state == State::Open && !m_isLate && now >= m_pausedUntil; }

    void welcome() { m_state = State::Measured; }
    // Echoes of the two sizes came back after so long. Opens the link.
    void setMeasured(double latencyNs, double nsPerByte);
    void lose() { m_state = State::Lost; }

    // The worker was heard, or is sent what it wakes up for.
    void noteContact(double now);
    // It has just answered.
    void noteAwake(double now) { m_lastContact = m_looksBy = now; }
    // Has heard nothing for long.
    bool isAsleep(double now) const { return dxPollPause::isLong(now - m_lastContact); }

    // --- problems ------------------------------------------------------------------------------------------
    const std::list<dxRemoteInFlight> &inFlight() const { return m_inFlight; }
    void send(dxRemoteInFlight &&problems, std::size_t bytes, double now);
    void withdraw(std::uint64_t number);
    // Returns whether there is a withdrawal of which the worker has not been told; from now on it has.
    bool takeWithdrawal(std::uint64_t &number);

    // The problems of this batch, of those that are not back, are found to take so many times what was thought.
    void rescale(std::uint64_t batch, double factor);

    // A message with results has arrived. Returns false if none is expected of this number; else what it should be about.
    bool takeBack(std::uint64_t number, double now, dxRemoteInFlight &problems);

    // The first deadline; infinite: there is none.
    double deadline() const;
    // Notes it if the deadline has gone by. Returns whether that is news.
    bool noticeLate(double now);

    // --- what was measured ---------------------------------------------------------------------------------
    double latencyNs() const { return m_latencyNs; }   // there and back
    double nsPerByte() const { return m_nsPerByte; }
    double slowness(double now) const;                 // time of a problem there, over that here

private:
    static constexpr unsigned kOnTimeToForget = 100;  // messages in a row that let the next pause be the first one's again
    static constexpr std::size_t kMaxInFlight = 2;  // one that is solved, and one that waits

    double begin(const dxRemoteInFlight &problems) const;
    void foresee(double from);
    double sleepNs(double now) const;

    State m_state = State::New;
    bool m_isLate = false;
    double m_lateSince = 0, m_pausedUntil = 0, m_pauseNs = 0;
    unsigned m_onTime = 0, m_answers = 0;
    double m_lastContact = 0, m_looksBy = 0;
    double m_latencyNs = 0, m_nsPerByte = 0;
    double m_slowness = 1, m_learntAt = 0;
    std::list<dxRemoteInFlight> m_inFlight;  // in the order in which they were sent
};

// What all usable workers together are to a step.
struct dxRemoteCapacity {
    unsigned workers = 0;
    double speed = 0;      // problems that they solve while a thread of this process solves one
    double latencyNs = 0;  // of the slowest link, there and back
    double nsPerByte = 0;

    void add(const dxRemoteLink &link, double now) {
        ++workers;
        speed += 1 / link.slowness(now);
        latencyNs = std::max(latencyNs, link.latencyNs());
        nsPerByte = std::max(nsPerByte, link.nsPerByte());
    }
};
