// QuickStep's sweep over the rows of an island (successive over-relaxation), which takes most of its time. docs/exact.md tells
// why the bits are those of upstream's loop.
#pragma once

#include "dynamics/step/islands/dxIslandProblem.h"

// Writes an order of the rows to problem.order that gives the results of taking unbounded rows first, then bounded ones, each in
// the order of their joints, and in which neighbours seldom wait for one another (level scheduling; dxSorSchedule.cpp has the source).
void dxScheduleSor(const dxIslandProblem &problem);

// Relaxes every row once, in this order. Each row's columns are scaled and its impulse is set (dxSorSolver).
void dxSorSweep(const dxIslandProblem &problem, const int *order);
