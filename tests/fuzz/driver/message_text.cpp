#include "message_text.h"

#include <cstdio>
#include <cstdlib>

namespace fuzz_driver {

namespace {

std::string nameOf(unsigned char byte) {
    char text[16];
    std::snprintf(text, sizeof text, "\\x%02x", byte);
    return text;
}

// U+0080 to U+009f are written with two bytes.
bool isControl(const std::string &text, std::size_t at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto next = static_cast<unsigned char>(at + 1 < text.size() ? text[at + 1] : '\0');
    if (byte == 0xc2) return next >= 0x80 && next < 0xa0;
    return byte < 0x20 || byte == 0x7f;
}

}  // namespace

std::string whatIsNoPlainLine(const std::string &text) {
    if (text.empty()) return "is empty";
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') return "has a second line";
        if (isControl(text, i))
            return "has the control character " + nameOf(static_cast<unsigned char>(text[i]));
    }
    return {};
}

std::string whatIsNoPlainText(const std::string &text) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\n' && isControl(text, i))
            return "has the control character " + nameOf(static_cast<unsigned char>(text[i]));
    return {};
}

std::string innerNameIn(const std::string &text) {
    for (const char *const name : {"/proc/self/fd", "<data-string>", "basic_string", "std::", "vector::",
                                   "map::at", "_M_", "bad_alloc", "json.exception", "terminate called"})
        if (text.find(name) != std::string::npos) return name;
    return {};
}

void setSanitizerOptions() {
    const std::string code = "exitcode=" + std::to_string(kSanitizerExitCode);
    for (const char *const variable : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"}) {
        const char *const set = getenv(variable);
        const std::string more = std::string(variable) == "ASAN_OPTIONS" ? ":detect_stack_use_after_return=0" : "";
        setenv(variable, ((set && *set ? std::string(set) + ":" : "") + code + more).c_str(), 1);
    }
}

std::string sanitizerReportIn(const std::string &text) {
    for (const char *const begin :
         {"ERROR: AddressSanitizer", "ERROR: LeakSanitizer", "runtime error:", "WARNING: ThreadSanitizer"})
        if (const std::size_t at = text.find(begin); at != std::string::npos) {
            const std::size_t line = text.rfind('\n', at);
            return text.substr(line == std::string::npos ? 0 : line + 1, 3000);
        }
    return {};
}

std::string shown(const std::string &text, std::size_t most) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (most < text.size() && i == most / 2) {
            plain += " [...] ";
            i = text.size() - most / 2;
        }
        const auto byte = static_cast<unsigned char>(text[i]);
        plain += byte < 0x20 || byte == 0x7f ? nameOf(byte) : std::string(1, text[i]);
    }
    return plain;
}

}  // namespace fuzz_driver
