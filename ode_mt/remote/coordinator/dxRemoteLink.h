// What the coordinator knows of one worker: whether it may get problems, how fast it is, what it has to do, and when results should arrive.
//
// A link is New until its worker has said hello, Measured while echoes are sent, Open when the worker may get problems, and Lost for ever when the
// worker disconnected, was refused, or sent invalid data. If a result is late, an open link gets no problems until all results have arrived, and then
// for a pause that doubles each time, up to ten seconds.
//
// A worker that has received nothing for a second looks for messages less often (dxPollPause). The link knows the time of the last message to it, so
// a result for a message to a sleeping worker is expected later, and is no measure of its speed.
//
// Only send() takes memory, and changes nothing if there is none.
//
// Units: times in ns of one clock, costs in ns of work in this process. Threading: under the lock of dxRemoteWorkers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <vector>

#include "remote/transport/dxPollPause.h"

// Problems that were sent in one message and have no result yet.
struct dxRemoteInFlight {
    std::uint64_t number;
    std::vector<std::uint64_t> problems;
    double cost;
    double transferNs;    // there and back, the worker's sleep included
    double sent;
    double expected = 0;  // when the results should arrive
    double deadline = 0;  // after which they are reclaimed
    bool isWithdrawn = false, isWithdrawalSent = false;
    bool meetsSleep = false;  // the worker may have been asleep
    bool isPatient = false;   // this process has no other work: it waits for seconds
};

class dxRemoteLink {
public:
    enum class State { New, Measured, Open, Lost };

    State state() const { return m_state; }
    bool isLate() const { return m_isLate; }
    // Returns whether it has been late for so long that it should be replaced, if that is possible.
    bool isGone(double now) const;
    // Returns whether it has answered often.
    bool hasProved() const { return m_answers >= kOnTimeToForget; }

    // Returns whether it may get problems now.
    bool isFree(double now) const;
    // Returns whether it may get problems as far as its state goes: open, not late, not in a pause.
    bool isUsable(double now) const { return m_state == State::Open && !m_isLate && now >= m_pausedUntil; }
    // Returns whether it is usable and has nothing to do.
    bool isIdle(double now) const { return isUsable(now) && m_inFlight.empty(); }

    void welcome() { m_state = State::Measured; }
    // Stores what echoes of the two sizes have measured. Opens the link.
    void setMeasured(double latencyNs, double nsPerByte);
    void lose() { m_state = State::Lost; }

    // Called when a message has come from the worker, or one is sent that wakes it.
    void noteContact(double now);
    // Called when it has just answered.
    void noteAwake(double now) { m_lastContact = m_looksBy = now; }
    // Returns whether it has received nothing for long.
    bool isAsleep(double now) const { return dxPollPause::isLong(now - m_lastContact); }

    // --- problems ------------------------------------------------------------------------------------------
    const std::list<dxRemoteInFlight> &inFlight() const { return m_inFlight; }
    void send(dxRemoteInFlight &&problems, std::size_t bytes, double now);
    void withdraw(std::uint64_t number);
    // Returns whether there is a withdrawal that has not been sent; from now on it counts as sent.
    bool takeWithdrawal(std::uint64_t &number);

    // Multiplies the predicted costs of those problems of this batch that have no result yet.
    void rescale(std::uint64_t batch, double factor);

    // Called when a message with results has arrived. Returns false if none is expected with this number; else sets `problems` to those it should
    // answer.
    bool takeBack(std::uint64_t number, double now, dxRemoteInFlight &problems);

    // Returns the first deadline; infinite: there is none.
    double deadline() const;
    // Notes if the deadline has passed. Returns whether that was not known.
    bool noticeLate(double now);

    // --- what was measured ---------------------------------------------------------------------------------
    double latencyNs() const { return m_latencyNs; }   // there and back
    double nsPerByte() const { return m_nsPerByte; }
    double slowness(double now) const;                 // time of a problem there, over that here

private:
    static constexpr unsigned kOnTimeToForget = 100;  // messages in a row after which the next pause is as short as the first
    static constexpr std::size_t kMaxInFlight = 2;    // one that is solved, and one that waits

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

// All usable workers together, for a step.
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
