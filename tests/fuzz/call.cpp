#include "call.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace fuzz {

namespace {

constexpr const char *kKinds[objectKinds] = {"world", "space", "body", "geom", "joint", "group", "meshData", "heightData"};
constexpr const char *kPlaces[places] = {"", "near", "moved", "message", "collider", "box", "triangle", "height"};

std::string textOf(double value) {
    if (std::isnan(value)) return "nan";
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string textOf(const Reference &reference) {
    return reference.number < 0 ? "null" : nameOf(reference.kind) + std::to_string(reference.number);
}

// Reads a line from the left.
class Reader {
public:
    explicit Reader(const std::string &line) : m_line(line) {}

    void skipBlanks() {
        while (m_at < m_line.size() && m_line[m_at] == ' ') ++m_at;
    }
    bool take(char what) {
        skipBlanks();
        if (m_at >= m_line.size() || m_line[m_at] != what) return false;
        ++m_at;
        return true;
    }
    void need(char what) {
        if (!take(what)) fail(std::string("'") + what + "' is missing");
    }
    std::string word() {
        skipBlanks();
        const std::size_t begin = m_at;
        while (m_at < m_line.size() && (std::isalnum(static_cast<unsigned char>(m_line[m_at])) != 0 || m_line[m_at] == '_'))
            ++m_at;
        return m_line.substr(begin, m_at - begin);
    }
    std::string upTo(char end) {
        const std::size_t begin = m_at;
        m_at = std::min(m_line.find(end, begin), m_line.size());
        const std::string text = m_line.substr(begin, m_at - begin);
        need(end);
        return text;
    }
    double number() {
        skipBlanks();
        const char *const begin = m_line.c_str() + m_at;
        char *end = nullptr;
        const double value = std::strtod(begin, &end);
        if (end == begin) fail("a number is missing");
        m_at += static_cast<std::size_t>(end - begin);
        return value;
    }
    char next() {
        skipBlanks();
        return m_at < m_line.size() ? m_line[m_at] : '\0';
    }
    std::size_t place() const { return m_at; }
    void goTo(std::size_t place) { m_at = place; }
    [[noreturn]] void fail(const std::string &what) const { throw std::runtime_error(what + ": " + m_line); }

private:
    const std::string &m_line;
    std::size_t m_at = 0;
};

bool isReference(const std::string &word, Reference &reference) {
    if (word == "null") {
        reference.number = -1;
        return true;
    }
    const std::size_t digits = word.find_first_of("0123456789");
    if (digits == std::string::npos) return false;
    for (int kind = 0; kind < objectKinds; ++kind) {
        if (word.compare(0, digits, kKinds[kind]) != 0) continue;
        reference = {static_cast<ObjectKind>(kind), std::atoi(word.c_str() + digits)};
        return true;
    }
    return false;
}

Argument readArgument(Reader &reader) {
    Argument argument;
    if (reader.take('{')) {
        argument.kind = Argument::Kind::numbers;
        while (!reader.take('}')) {
            argument.numbers.push_back(reader.number());
            reader.take(',');
        }
        return argument;
    }
    if (reader.take('"')) {
        argument.kind = Argument::Kind::word;
        argument.word = reader.upTo('"');
        return argument;
    }
    const std::size_t place = reader.place();
    if (isReference(reader.word(), argument.reference)) {
        argument.kind = Argument::Kind::reference;
        return argument;
    }
    reader.goTo(place);
    argument.numbers.push_back(reader.number());
    return argument;
}

}  // namespace

const char *nameOf(ObjectKind kind) { return kKinds[static_cast<int>(kind)]; }

Argument argumentOf(double number) {
    Argument argument;
    argument.numbers.push_back(number);
    return argument;
}

Argument argumentOf(const Reference &reference) {
    Argument argument;
    argument.kind = Argument::Kind::reference;
    argument.reference = reference;
    return argument;
}

std::string textOf(const Argument &argument) {
    if (argument.kind == Argument::Kind::reference) return textOf(argument.reference);
    if (argument.kind == Argument::Kind::number) return textOf(argument.numbers.at(0));
    if (argument.kind == Argument::Kind::word) return '"' + argument.word + '"';
    std::string text = "{";
    for (const double value : argument.numbers) text += (text.size() > 1 ? ", " : "") + textOf(value);
    return text + "}";
}

std::string textOf(const Call &call) {
    std::string text;
    if (call.where != Where::between)
        text += std::string("  ") + kPlaces[static_cast<int>(call.where)] + ' ' + std::to_string(call.turn) + ": ";
    if (call.result.number >= 0) text += textOf(call.result) + " = ";
    text += call.function + '(';
    for (std::size_t i = 0; i < call.arguments.size(); ++i) text += (i != 0 ? ", " : "") + textOf(call.arguments[i]);
    return text + ");";
}

Call callOf(const std::string &line) {
    Reader reader(line);
    Call call;
    std::string word = reader.word();
    for (int place = 1; place < places; ++place) {
        if (word != kPlaces[place]) continue;
        call.where = static_cast<Where>(place);
        call.turn = static_cast<int>(reader.number());
        reader.need(':');
        word = reader.word();
        break;
    }
    if (isReference(word, call.result)) {
        reader.need('=');
        word = reader.word();
    }
    call.function = word;
    reader.need('(');
    while (!reader.take(')')) {
        call.arguments.push_back(readArgument(reader));
        if (reader.next() != ')') reader.need(',');
    }
    reader.need(';');
    return call;
}

std::string textOf(const Script &script) {
    std::string text;
    for (const Call &call : script) text += textOf(call) + '\n';
    return text;
}

Script scriptOf(const std::string &text) {
    Script script;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#' && line.compare(0, 4, "    ") != 0) script.push_back(callOf(line));
    return script;
}

}  // namespace fuzz
