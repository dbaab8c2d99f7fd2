// One line to stderr for the person who runs the program: "ODE_MT warning: ...".
//
// The environment variable ODE_MT_LOG names the most verbose level that is shown: error, warning (the default), info or
// debug. Upstream's dMessage and dError stay upstream's; this is for what only ODE_MT has to say. Any thread may call;
// a line is written in one piece.
#pragma once

enum class dxLogLevel { error, warning, info, debug };

// Reads a level's name; false if there is no such level.
bool dxLogLevelFromName(const char *name, dxLogLevel &level);

dxLogLevel dxGetLogLevel();
void dxSetLogLevel(dxLogLevel level);

// Text without the "ODE_MT level: " in front and without the line end; cut after 1000 characters.
void dxLog(dxLogLevel level, const char *format, ...) __attribute__((format(printf, 2, 3)));
