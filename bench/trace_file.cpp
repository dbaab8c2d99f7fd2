#include "trace_file.h"

#include <filesystem>

namespace bench {

namespace {

std::string plain(std::string name) {
    for (char &c : name) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (!isPlain) c = '-';
    }
    return name;
}

}  // namespace

std::string traceFileOf(const std::string &file, const std::string &world, const std::string &engine, std::size_t runs) {
    if (file.empty() || runs < 2) return file;
    const std::filesystem::path path(file), name = std::filesystem::path(world).stem();
    std::filesystem::path result = path.parent_path() / path.stem();
    result += "-" + plain(name.string()) + "-" + plain(engine) + path.extension().string();
    return result.string();
}

}  // namespace bench
