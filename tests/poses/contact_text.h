// What one call of dCollide answers, as text: the bits of every number that colliders fill in.
#pragma once

#include "pose_shape.h"
#include "questions.h"

#include <string>

namespace poses {

// Contacts, or the text with which upstream gives up.
class ContactText {
public:
    ContactText();
    ~ContactText();
    ContactText(const ContactText &) = delete;
    ContactText &operator=(const ContactText &) = delete;

    std::string ask(const PoseShape &one, const PoseShape &other, const Question &question);
    bool gaveUp() const { return m_gaveUp; }  // at the last call

private:
    void tell(const dContactGeom &contact, const PoseShape &one, const PoseShape &other);

    std::string m_text;
    bool m_gaveUp = false;
};

}  // namespace poses
