#include "contact_text.h"

#include <cmath>
#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace poses {

namespace {

constexpr unsigned char fresh = 0xa5;  // what contacts hold before a collider fills them in

// A debug handler gets no argument of the user's.
std::jmp_buf g_giveUp;
char g_reason[500];

void giveUp(int, const char *format, va_list arguments) {
    std::vsnprintf(g_reason, sizeof(g_reason), format, arguments);
    std::longjmp(g_giveUp, 1);
}

// No variable of the caller's changes between setjmp and longjmp.
bool collide(dGeomID one, dGeomID other, const Question &question, std::vector<unsigned char> &memory,
             int *count) {
    if (setjmp(g_giveUp) != 0) return false;
    *count =
        dCollide(one, other, question.flags, reinterpret_cast<dContactGeom *>(memory.data()), question.skip);
    return true;
}

// All NaNs are one: their signs follow from the order of operands, which compilers are free to change.
std::string bits(dReal number) {
    if (std::isnan(number)) return "nan";
    unsigned long long pattern = 0;
    std::memcpy(&pattern, &number, sizeof(number));
    char text[20];
    std::snprintf(text, sizeof(text), "%llx", pattern);
    return text;
}

char owner(dGeomID geom, const PoseShape &one, const PoseShape &other) {
    dGeomID unset;
    std::memset(&unset, fresh, sizeof(unset));
    if (geom == unset) return 'u';  // colliders count contacts of no importance that they do not fill in
    if (one.owns(geom)) return geom == one.geom() ? 'a' : 'c';
    if (other.owns(geom)) return geom == other.geom() ? 'b' : 'd';
    return '?';
}

}  // namespace

ContactText::ContactText() { dSetDebugHandler(giveUp); }
ContactText::~ContactText() { dSetDebugHandler(nullptr); }

std::string ContactText::ask(const PoseShape &one, const PoseShape &other, const Question &question) {
    const int asked = question.flags & 0xffff;
    std::vector<unsigned char> memory(static_cast<std::size_t>(asked) * question.skip, fresh);
    int count = 0;
    m_gaveUp = !collide(one.geom(), other.geom(), question, memory, &count);
    if (m_gaveUp) return g_reason;
    m_text = std::to_string(count);
    for (int i = 0; i < count; ++i)
        tell(*reinterpret_cast<const dContactGeom *>(memory.data() +
                                                     static_cast<std::size_t>(i) * question.skip),
             one, other);
    return m_text;
}

void ContactText::tell(const dContactGeom &contact, const PoseShape &one, const PoseShape &other) {
    m_text += std::string(" | ") + owner(contact.g1, one, other) + owner(contact.g2, one, other);
    m_text += " " + std::to_string(contact.side1) + " " + std::to_string(contact.side2);
    for (int i = 0; i < 3; ++i) m_text += " " + bits(contact.pos[i]);
    for (int i = 0; i < 3; ++i) m_text += " " + bits(contact.normal[i]);
    m_text += " " + bits(contact.depth);
}

}  // namespace poses
