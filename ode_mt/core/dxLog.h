// The log: lines on stderr for the person who runs the program, as "ODE_MT warning: ...".
//
// The environment variable ODE_MT_LOG names the most verbose level that is shown: error, warning (the default), info or
// debug. The log is for messages that only ODE_MT has; upstream's are reported with dMessage and dError.
//
// Threading: any thread; a line is written by one call, so lines of several threads are not mixed.
#pragma once

enum class dxLogLevel { Error, Warning, Info, Debug };

// Reads the name of a level. Returns false if there is no such level.
bool dxLogLevelFromName(const char *name, dxLogLevel &level);

dxLogLevel dxGetLogLevel();
void dxSetLogLevel(dxLogLevel level);

// Writes a line: "ODE_MT level: " and the text, which is cut after 1000 characters.
void dxLog(dxLogLevel level, const char *format, ...) __attribute__((format(printf, 2, 3)));
