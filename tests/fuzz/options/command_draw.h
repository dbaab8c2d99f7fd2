// Command lines drawn from the tables of options: with values that are right, wrong, and far from either.
#pragma once

#include "driver/random.h"
#include "options/option_table.h"
#include "options/tool.h"

#include <string>
#include <vector>

namespace fuzz_options {

struct Program {
    std::string name, file;
    std::vector<Option> options;
};

const char *const kRecordingFile = "recording.json", *const kResultsFile = "results.json";  // in the folder of the command

// Values that take long are excluded: runs measure little, and end soon.
Command drawCommand(const Program &program, fuzz_driver::Random &random);

}  // namespace fuzz_options
