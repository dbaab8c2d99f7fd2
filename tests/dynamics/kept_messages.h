// Handlers of messages and errors that keep what they hear.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

inline std::string keptMessages;

inline void keepMessage(int number, const char *format, va_list arguments) {
    char text[200];
    std::vsnprintf(text, sizeof text, format, arguments);
    keptMessages += std::to_string(number) + ": " + text + "\n";
}

// A failed assertion, such as that of a body that has moved to nowhere, leaves the call that it comes in.
[[noreturn]] inline void keepMessageAndLeave(int number, const char *format, va_list arguments) {
    keepMessage(number, format, arguments);
    throw std::runtime_error(keptMessages);
}
