#include "options/option_table.h"

#include "support/text.h"

#include <sstream>
#include <stdexcept>

namespace fuzz_options {

namespace {

// "--no-averages{false}" as "--no-averages".
std::string withoutValue(const std::string &name) { return name.substr(0, name.find('{')); }

Option readLine(const std::string &line, bool isPositional) {
    std::istringstream words(line);
    std::string names, type;
    words >> names;
    if (line.find("  ", 2 + names.size()) != 2 + names.size()) words >> type;
    Option option;
    option.isPositional = isPositional;
    option.name = withoutValue(support::split(names, ',').back());
    const std::size_t brace = type.find('{'), end = type.find('}');
    if (brace != std::string::npos && end != std::string::npos)
        option.choices = support::split(type.substr(brace + 1, end - brace - 1), ',');
    option.type = type.substr(0, type.find_first_of("=:{"));
    return option;
}

}  // namespace

std::vector<Option> readOptionTable(const std::string &help) {
    std::vector<Option> table;
    bool isOption = false, isPositional = false;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        if (line == "Options:" || line == "Positionals:") {
            isOption = true;
            isPositional = line == "Positionals:";
        } else if (line.empty()) {
            isOption = false;
        } else if (isOption && line.size() > 2 && line.compare(0, 2, "  ") == 0 && line[2] != ' ') {
            table.push_back(readLine(line, isPositional));
        }
    }
    if (table.size() < 2) throw std::runtime_error("--help lists no options:\n" + help);
    return table;
}

}  // namespace fuzz_options
