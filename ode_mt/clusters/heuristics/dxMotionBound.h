// How far the members of a world can travel in some frames, at most: what allows a check to be skipped.
//
// A frame moves a point by its speed at the end of the frame times the time step (ODE integrates velocities
// first), and the speed grows by at most acceleration x step a frame. So no point of a member travels further
// in k frames of step h than
//
//   reach(k) = k (v h + r) + a h² k (k + 1) / 2
//
// and two members whose gap g (smallest distance between any two that are to be kept apart) is larger than
// 2 reach(k) have not met at any time in these frames: each would have to come half of the way.
//
// Numbers are taken so that rounding makes the reach larger, never smaller.
#pragma once

// SI units. For members that turn, of the fastest point: |linear velocity| + |angular velocity| x radius.
struct dxMotionBound {
    double speed;         // m/s, of the fastest member when the frames begin
    double acceleration;  // m/s², by which that speed can grow. 0 if the speed bounds the frames themselves
    double step;          // s, of a frame
    double rounding;  // m, by which rounding moves a member in a frame: half an ulp of the largest coordinate

    // False if a number is NaN, infinite or negative: such motion bounds nothing.
    bool proves() const;

    double reach(unsigned frames) const;  // m; infinite or NaN if it is too large for a double
};

// For how many frames, at most `limit`, members with this gap need no check: the first frame's positions are
// the present ones, each later frame's those after one more step. 0: they may have met already.
unsigned dxFramesApart(const dxMotionBound &motion, double gap, unsigned limit);
