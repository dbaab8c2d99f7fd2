// Standard input for a program that runs several times: what its first run is given is kept, and given to the others again.
//
// A terminal is not handed on: nobody types the same twice. Programs find its end at once then.
#pragma once

#include <string>

namespace check {

class ProgramInput {
public:
    explicit ProgramInput(int source);

    bool isEmpty() const { return m_source < 0; }
    // To be polled for reading during the first run; -1: there is no more.
    int source() const { return m_isEnded ? -1 : m_source; }
    // Reads some more of the source.
    void readSource();

    // All that has been read yet.
    const std::string &text() const { return m_text; }
    bool isEnded() const { return m_isEnded; }
    // Behind the first run.
    void end() { m_isEnded = true; }

private:
    int m_source;  // -1: none
    bool m_isEnded;
    std::string m_text;
};

}  // namespace check
