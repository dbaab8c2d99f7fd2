// The states of a heuristic, and which may follow which (thesis, figure A.4, which names the states only).
//
//             start            pause
//   Init ─────────────► Running ─────► Paused      Init     created, has never run
//                       ▲  ▲             │         Reset    as created, waits for its start
//   Reset ──────────────┘  └─────────────┘         Running  takes a sample, or judges, once a frame
//     start                    start               Paused   keeps everything, does nothing
//                                                  Stopped  over; what it found can still be read
//   any state ──reset──► Reset
//   any state but Stopped ──stop──► Stopped        nothing returns to Init
#pragma once

enum class dxHeuristicState { Init, Reset, Running, Paused, Stopped };

bool dxMayFollow(dxHeuristicState from, dxHeuristicState to);
