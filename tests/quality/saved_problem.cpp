#include "saved_problem.h"

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <type_traits>

namespace quality {

namespace {

template <class Item>
void writeAll(std::ostream &file, const std::vector<Item> &items) {
    static_assert(std::is_trivially_copyable_v<Item>, "items are written as bytes");
    const std::uint64_t count = items.size();
    file.write(reinterpret_cast<const char *>(&count), sizeof count);
    file.write(reinterpret_cast<const char *>(items.data()), std::streamsize(count * sizeof(Item)));
}

template <class Item>
void readAll(std::istream &file, std::vector<Item> &items) {
    std::uint64_t count = 0;
    file.read(reinterpret_cast<char *>(&count), sizeof count);
    if (!file) return;
    items.resize(count);
    file.read(reinterpret_cast<char *>(items.data()), std::streamsize(count * sizeof(Item)));
}

}  // namespace

void write(const std::vector<SavedProblem> &problems, const std::string &path) {
    std::ofstream file(path, std::ios::binary);
    for (const SavedProblem &problem : problems) {
        writeAll(file, problem.bodies);
        writeAll(file, problem.joints);
        writeAll(file, problem.contacts);
    }
    if (!file) throw std::runtime_error(path + " cannot be written to");
}

std::vector<SavedProblem> readProblems(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<SavedProblem> problems;
    while (file && file.peek() != std::ifstream::traits_type::eof()) {
        SavedProblem &problem = problems.emplace_back();
        readAll(file, problem.bodies);
        readAll(file, problem.joints);
        readAll(file, problem.contacts);
    }
    if (!file || problems.empty()) throw std::runtime_error(path + " holds no problems");
    return problems;
}

}  // namespace quality
