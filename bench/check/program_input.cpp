#include "check/program_input.h"

#include <unistd.h>

#include <cerrno>

namespace check {

ProgramInput::ProgramInput(int source) : m_source(isatty(source) ? -1 : source), m_isEnded(m_source < 0) {}

void ProgramInput::readSource() {
    char bytes[1 << 16];
    const ssize_t count = read(m_source, bytes, sizeof bytes);
    if (count > 0)
        m_text.append(bytes, static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
        m_isEnded = true;
}

}  // namespace check
