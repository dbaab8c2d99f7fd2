#include "worlds/case_mutation.h"

#include "driver/drawn_text.h"
#include "worlds/tree_mutation.h"

#include <algorithm>
#include <cctype>

namespace fuzz_worlds {

namespace {

using fuzz_driver::Random;

std::size_t drawPlace(const std::string &text, Random &random) { return random.below(text.size() + 1); }

// Bytes flipped, cut off, put in, doubled.
void mutateBytes(std::string &text, Random &random) {
    const std::size_t at = drawPlace(text, random),
                      length = std::min(text.size() - at, 1 + random.below(random.oneIn(3) ? 400 : 8));
    switch (random.below(6)) {
        case 0:
            text.resize(at);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(drawPlace(text, random), length));
            break;
        case 3:
            text.insert(at, fuzz_driver::drawText(random));
            break;
        default:
            for (std::size_t flips = 1 + random.below(4); flips > 0 && !text.empty(); --flips)
                text[random.below(text.size())] =
                    static_cast<char>(random.oneIn(4) ? 255 * random.below(2) : random.below(256));
    }
}

// One of the numbers in a text, of a mesh for one.
void replaceNumber(std::string &text, Random &random) {
    const auto isPart = [&](std::size_t at) {
        return std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.' || text[at] == '-';
    };
    std::size_t begin = drawPlace(text, random);
    while (begin < text.size() && !isPart(begin)) ++begin;
    std::size_t end = begin;
    while (end < text.size() && isPart(end)) ++end;
    if (begin < end) text.replace(begin, end - begin, fuzz_driver::drawNumber(random));
}

void mutateFile(const std::string &file, std::string &text, const std::vector<std::string> &references,
                Random &random) {
    if (isXml(file) && !random.oneIn(8)) {
        if (const auto xml = parseXml(text)) {
            mutateTree(*xml, random, references);
            text = printXml(*xml);
            return;
        }
    }
    if (random.oneIn(2))
        replaceNumber(text, random);
    else
        mutateBytes(text, random);
}

}  // namespace

void mutateCase(WorldCase &world, Random &random) {
    std::vector<std::string> names, references = {"model://part",
                                                  "model://nothing",
                                                  "..",
                                                  ".",
                                                  "/",
                                                  "/dev/zero",
                                                  "file:///etc/passwd",
                                                  "models",
                                                  "model://../part",
                                                  "http://localhost/x",
                                                  "model://part/model.sdf"};
    for (const auto &file : world.files) names.push_back(file.first);
    references.insert(references.end(), names.begin(), names.end());
    const std::size_t changes = 1 + random.below(random.oneIn(4) ? 10 : 3);
    for (std::size_t i = 0; i < changes; ++i) {
        const std::string &file = random.oneIn(3) ? random.of(names) : kWorldFile;
        mutateFile(file, world.files[file], references, random);
    }
    if (names.size() > 1 && random.oneIn(60))
        world.files.erase(names[random.below(names.size())] == kWorldFile ? names.back() : names.front());
    if (world.files.count(kWorldFile) == 0) world.files[kWorldFile] = "";
    world.ignoreUnsupported = random.oneIn(4);
    world.staticMeetsStatic = random.oneIn(6);
    world.staticShapes = random.oneIn(8) ? 1 + random.below(300) : 0;
}

}  // namespace fuzz_worlds
