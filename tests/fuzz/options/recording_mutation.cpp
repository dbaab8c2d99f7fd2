#include "options/recording_mutation.h"

#include "driver/drawn_text.h"
#include "support/text.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace fuzz_options {

namespace {

using fuzz_driver::Random;
using nlohmann::json;

std::string joined(const std::vector<std::string> &lines, const std::string &end) {
    std::string text;
    for (const std::string &line : lines) text += line + end;
    return text;
}

json drawScalar(Random &random) {
    switch (random.below(7)) {
        case 0:
            return nullptr;
        case 1:
            return random.oneIn(2);
        case 2: {
            const json text = fuzz_driver::drawText(random);
            return json::parse(text.dump(-1, ' ', false, json::error_handler_t::replace));
        }
        case 3:
            return json::array();
        case 4:
            return json::object();
        default: {
            const json number = json::parse(fuzz_driver::drawNumber(random), nullptr, false);
            return number.is_discarded() ? json(-1) : number;
        }
    }
}

json *drawValue(json &root, Random &random) {
    json *at = &root;
    while (at->is_structured() && !at->empty() && !random.oneIn(5)) {
        auto child = at->begin();
        std::advance(child, static_cast<std::ptrdiff_t>(random.below(at->size())));
        at = &*child;
    }
    return at;
}

void change(json &value, Random &random) {
    switch (random.below(5)) {
        case 0:
            if (value.is_array() && !value.empty()) return value.erase(random.below(value.size()));
            if (value.is_object() && !value.empty()) {
                auto member = value.begin();
                std::advance(member, static_cast<std::ptrdiff_t>(random.below(value.size())));
                value.erase(member);
                return;
            }
            break;
        case 1:
            if (value.is_array()) {
                value.insert(value.begin() + static_cast<std::ptrdiff_t>(random.below(value.size() + 1)),
                             value.empty() ? drawScalar(random) : json(value[random.below(value.size())]));
                return;
            }
            break;
        case 2:
            if (value.is_number()) {
                value = value.get<double>() * (random.oneIn(2) ? -1 : 1e13);
                return;
            }
            break;
        default:
            break;
    }
    value = drawScalar(random);
}

// "[[[[...]]]]" in place of one of the values, as text: the library would not survive to write it.
std::string nested(const std::string &line, Random &random) {
    const std::size_t depth = 1 + random.below(random.oneIn(3) ? 300'000 : 100);
    const std::size_t at = line.find(random.oneIn(2) ? ":" : ",", random.below(line.size() + 1));
    if (at == std::string::npos) return line;
    const std::size_t end = line.find_first_of(",]}", at + 1);
    return line.substr(0, at + 1) + std::string(depth, '[') + std::string(depth, ']') +
           (end == std::string::npos ? "" : line.substr(end));
}

void mutateLine(std::string &line, Random &random) {
    if (random.oneIn(12)) {
        line = nested(line, random);
        return;
    }
    if (random.oneIn(6)) {
        const std::size_t at = random.below(line.size() + 1);
        if (random.oneIn(2))
            line.resize(at);
        else
            line.insert(at, fuzz_driver::drawText(random));
        return;
    }
    json value = json::parse(line, nullptr, false);
    if (value.is_discarded()) return;
    for (std::size_t changes = 1 + random.below(3); changes > 0; --changes)
        change(*drawValue(value, random), random);
    line = value.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string mutatedLines(const std::string &text, Random &random) {
    std::vector<std::string> lines = support::split(text, '\n');
    for (std::size_t changes = 1 + random.below(3); changes > 0 && !lines.empty(); --changes) {
        std::string &line = lines[random.below(lines.size())];
        switch (random.below(12)) {
            case 0:
                line = lines[random.below(lines.size())];
                break;
            case 1:
                lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(random.below(lines.size())));
                break;
            case 2:
                lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(random.below(lines.size() + 1)),
                             random.oneIn(2) ? "" : fuzz_driver::drawText(random));
                break;
            default:
                mutateLine(line, random);
        }
    }
    return joined(lines, random.oneIn(10) ? "\r\n" : "\n");
}

}  // namespace fuzz_options
