// A handler of messages that keeps the last one.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

inline std::string lastMessage;

inline void keepLastMessage(int, const char *format, va_list arguments) {
    char text[2000];
    std::vsnprintf(text, sizeof text, format, arguments);
    lastMessage = text;
}
