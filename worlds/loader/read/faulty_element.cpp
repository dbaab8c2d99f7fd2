#include "loader/read/faulty_element.h"

#include "loader/read/element_path.h"
#include "loader/read/source_place.h"

#include <sdf/Collision.hh>
#include <sdf/Frame.hh>
#include <sdf/Joint.hh>
#include <sdf/Link.hh>
#include <sdf/parser.hh>
#include <sdf/Root.hh>

#include <algorithm>

namespace worlds {

namespace {

class FaultSearch {
public:
    FaultSearch(const std::string &version, const std::string &message, const sdf::ParserConfig &config)
        : m_message(message), m_config(config), m_alone(new sdf::SDF()) {
        sdf::init(m_alone);
        m_alone->Root()->GetAttribute("version")->SetFromString(version);
    }

    sdf::ElementPtr within(sdf::ElementPtr group) {
        while (const sdf::ElementPtr model = faultyModel(group)) group = model;
        if (const sdf::ElementPtr part = faultyPart(group)) return part;
        for (const std::string &name : namesIn(m_message))
            if (const sdf::ElementPtr part = named(group, name)) return part;
        return group;
    }

private:
    // A model fails alike without what is around it, because it may not refer to that.
    sdf::ElementPtr faultyModel(const sdf::ElementPtr &group) {
        sdf::ElementPtr faulty;
        forEachWritten(group, [&](const sdf::ElementPtr &child) {
            if (faulty || child->GetName() != "model") return;
            const sdf::ElementPtr copy = child->Clone();
            if (copy->HasElement("pose"))
                copy->RemoveChild(copy->GetElement("pose"));  // may be in an outer frame
            m_alone->Root()->ClearElements();
            m_alone->Root()->InsertElement(copy);
            if (gives(sdf::Root().Load(m_alone, m_config))) faulty = child;
        });
        return faulty;
    }

    sdf::ElementPtr faultyPart(const sdf::ElementPtr &group) const {
        sdf::ElementPtr faulty;
        forEachWritten(group, [&](const sdf::ElementPtr &child) {
            if (faulty) return;
            const std::string kind = child->GetName();
            if (kind == "link" && gives(sdf::Link().Load(child))) {
                const sdf::ElementPtr inside = faultyPart(child);
                faulty = inside ? inside : child;
            }
            const bool isFaulty = (kind == "joint" && gives(sdf::Joint().Load(child))) ||
                                  (kind == "frame" && gives(sdf::Frame().Load(child))) ||
                                  (kind == "collision" && gives(sdf::Collision().Load(child)));
            if (isFaulty) faulty = child;
        });
        return faulty;
    }

    // Models inside are no parts: their names are others.
    static sdf::ElementPtr named(const sdf::ElementPtr &group, const std::string &name) {
        sdf::ElementPtr found;
        forEachWritten(group, [&](const sdf::ElementPtr &child) {
            if (found) return;
            const sdf::Param_V &attributes = child->GetAttributes();
            const auto is = [&](const sdf::ParamPtr &value) { return value && value->GetAsString() == name; };
            if (is(child->GetValue()) || std::any_of(attributes.begin(), attributes.end(), is))
                found = child;
            else if (child->GetName() != "model")
                found = named(child, name);
        });
        return found;
    }

    bool gives(const sdf::Errors &errors) const {
        return std::any_of(errors.begin(), errors.end(),
                           [&](const sdf::Error &error) { return error.Message() == m_message; });
    }

    const std::string &m_message;
    const sdf::ParserConfig &m_config;
    sdf::SDFPtr m_alone;  // holds one model
};

}  // namespace

sdf::ElementPtr findFaultyElement(const sdf::ElementPtr &root, const std::string &message,
                                  const sdf::ParserConfig &config) {
    const sdf::ElementPtr world = root->FindElement("world");
    return FaultSearch(root->GetAttribute("version")->GetAsString(), message, config)
        .within(world ? world : root);
}

}  // namespace worlds
