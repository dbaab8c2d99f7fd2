// Draws calls from bytes. When the bytes are used up, everything is 0 and the script ends.
#pragma once

#include "function.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz {

class Draw {
public:
    Draw(const std::uint8_t *bytes, std::size_t count);

    bool isOver() const { return m_at >= m_count; }
    unsigned below(unsigned limit);  // 0 if the limit is 0
    bool oneIn(unsigned n) { return below(n) == 0; }

    // A function that may be called there, and its arguments. False: none of the objects that it needs lives.
    const Function &function(Where where);
    bool arguments(const Function &function, const Objects &objects, Arguments &arguments);

    // The scene to begin with.
    unsigned bodies() const { return m_bodies; }
    bool isHeap() const { return m_isHeap; }  // of bodies that lie in contact
    int spaceKind() const { return m_spaceKind; }

private:
    std::uint8_t byte();
    void chooseFocus();
    double number(Meaning meaning);
    double ordinary(Meaning meaning);
    double unusual();
    bool draw(const Function &function, const Objects &objects, Arguments &arguments);
    bool object(const Parameter &parameter, const Objects &objects, Argument &argument);
    void pose(const Parameter &parameter, Argument &argument);

    enum class Mode { ordinary, tiny, huge, zero, broken };

    const std::uint8_t *const m_bytes;
    const std::size_t m_count;
    std::size_t m_at = 0;
    Mode m_mode;
    unsigned m_bodies;
    bool m_isHeap;
    int m_spaceKind;
    // Functions of which this script calls many. By place; empty: as many as of others.
    std::array<std::vector<const Function *>, places> m_focus;
};

}  // namespace fuzz
