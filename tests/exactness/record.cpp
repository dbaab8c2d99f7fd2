#include "record.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace exactness {

using nlohmann::json;

namespace {

std::string hex(std::uint64_t bits) {
    char text[17];
    std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(bits));
    return text;
}

}  // namespace

// Reals are kept as strings of their bits, integers as numbers: JSON has no way to write a NaN, and
// decimal digits are not bits.
static void to_json(json &out, const Word &word) {
    if (word.kind == Word::Kind::Real) {
        out = hex(word.bits);
    } else {
        out = static_cast<std::int64_t>(word.bits);
    }
}

static void from_json(const json &in, Word &word) {
    if (in.is_string()) {
        word = {Word::Kind::Real, std::stoull(in.get<std::string>(), nullptr, 16)};
    } else {
        word = {Word::Kind::Integer, static_cast<std::uint64_t>(in.get<std::int64_t>())};
    }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Engine, library, isOdeMt, parallelSteps, parallelIslands, teamSteps,
                                   parallelCollisions, maxWorkers, instructionSet)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StageHash, step, stage, hash)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Value, stage, object, field, words, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Record, engine, stages, values)

void Record::write(const std::string &path) const {
    std::ofstream file(path);
    file << json(*this).dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    if (!file.flush()) throw std::runtime_error("cannot write the record " + path);
}

Record Record::read(const std::string &path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("no record " + path);
    try {
        return json::parse(file).get<Record>();
    } catch (const json::exception &error) {
        throw std::runtime_error("the record " + path + " is damaged: " + error.what());
    }
}

}  // namespace exactness
