#include "protocol.h"

#include "support/text.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace bench {

using nlohmann::json;

namespace {

// JSON has no 64-bit integers that every reader keeps, so hashes travel as text.
std::uint64_t readHash(const std::string &text) { return std::stoull(text, nullptr, 16); }

// Bytes that are no UTF-8 (file names may be anything) become U+FFFD instead of an exception.
std::string dump(const json &value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

// Pairs of a bin and its number of frames.
json toJson(const FrameTimes &times) {
    json bins = json::array();
    for (const auto &[bin, frames] : times.counts()) bins.push_back(json::array({bin, frames}));
    return bins;
}

// Reads the member `key` of the object in `line` with `read`.
template <class Reader>
auto parse(const std::string &line, const char *key, Reader read) -> decltype(read(json())) {
    json message;
    try {
        message = json::parse(line);
        if (!message.contains("error")) return read(message.at(key));
    } catch (const std::exception &) {  // its words are of the library's inside
        throw std::runtime_error("expected a line with '" + std::string(key) + "', got " + support::quote(line));
    }
    throw std::runtime_error(message["error"].get<std::string>());
}

}  // namespace

std::string hashText(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string writeReady(const Ready &r) {
    return dump({{"ready",
                  {{"library", r.library},
                   {"isOurs", r.isOurs},
                   {"release", r.release},
                   {"threads", r.threads},
                   {"manager", r.manager},
                   {"algorithm", r.algorithm},
                   {"callbacks", r.callbacks},
                   {"gridCells", r.gridCells},
                   {"bodies", r.bodies},
                   {"joints", r.joints},
                   {"geoms", r.geoms},
                   {"stepSize", r.stepSize},
                   {"warnings", r.warnings}}}});
}

Ready readReady(const std::string &line) {
    return parse(line, "ready", [](const json &from) {
        Ready r;
        from.at("library").get_to(r.library);
        from.at("isOurs").get_to(r.isOurs);
        from.at("release").get_to(r.release);
        from.at("threads").get_to(r.threads);
        from.at("manager").get_to(r.manager);
        from.at("algorithm").get_to(r.algorithm);
        from.at("callbacks").get_to(r.callbacks);
        from.at("gridCells").get_to(r.gridCells);
        from.at("bodies").get_to(r.bodies);
        from.at("joints").get_to(r.joints);
        from.at("geoms").get_to(r.geoms);
        from.at("stepSize").get_to(r.stepSize);
        from.at("warnings").get_to(r.warnings);
        return r;
    });
}

std::string writeRequest(int frames) { return dump({{"frames", frames}}); }

int readRequest(const std::string &line) {
    return parse(line, "frames", [](const json &from) { return from.get<int>(); });
}

std::string writeBatch(const Batch &b) {
    return dump({{"batch",
                  {{"frames", b.frames},
                   {"control", b.seconds.control},
                   {"collide", b.seconds.collide},
                   {"step", b.seconds.step},
                   {"finish", b.seconds.finish},
                   {"callbacks", b.seconds.callbacks},
                   {"frameTimes", toJson(b.frameTimes)},
                   {"hash", hashText(b.hash)},
                   {"contacts", b.contacts},
                   {"messages", b.messages},
                   {"sharedSteps", b.sharedSteps},
                   {"aloneSeconds", b.work.alone},
                   {"sharedSeconds", b.work.shared}}}});
}

Batch readBatch(const std::string &line) {
    return parse(line, "batch", [](const json &from) {
        Batch b;
        from.at("frames").get_to(b.frames);
        from.at("control").get_to(b.seconds.control);
        from.at("collide").get_to(b.seconds.collide);
        from.at("step").get_to(b.seconds.step);
        from.at("finish").get_to(b.seconds.finish);
        from.at("callbacks").get_to(b.seconds.callbacks);
        for (const json &bin : from.at("frameTimes")) b.frameTimes.add(bin.at(0).get<int>(), bin.at(1).get<long>());
        b.hash = readHash(from.at("hash").get<std::string>());
        from.at("contacts").get_to(b.contacts);
        from.at("messages").get_to(b.messages);
        from.at("sharedSteps").get_to(b.sharedSteps);
        from.at("aloneSeconds").get_to(b.work.alone);
        from.at("sharedSeconds").get_to(b.work.shared);
        return b;
    });
}

std::string writeError(const std::string &what) { return dump({{"error", support::printable(what)}}); }

}  // namespace bench
