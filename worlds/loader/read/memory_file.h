// A text that can be opened as a file, by this process and while the object lives.
#pragma once

#include <string>

namespace worlds {

class MemoryFile {
public:
    // Throws std::system_error.
    explicit MemoryFile(const std::string &text);
    ~MemoryFile();
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;

    std::string name() const;

private:
    int m_descriptor;
};

}  // namespace worlds
