// Every rule of the table of elements: a world that keeps it loads and runs, one that breaks it does not,
// and the error names file, element and reason.
#include "loader/read/element_rules.h"

#include "rule_world.h"
#include "small_world.h"
#include "test_folder.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

using rule_world::RuleWorld;
using worlds::ElementRule;
using worlds::NamedRule;
using worlds::Type;
using worlds::Use;

// One way to break a rule, and a part of the error's reason.
struct Violation {
    std::string name;
    std::function<void(tinyxml2::XMLElement &)> apply;
    std::string reason;
};

bool isNumber(Type type) {
    return type == Type::Numbers || type == Type::Whole || type == Type::Mask || type == Type::Limit || type == Type::Direction;
}
bool isValue(Type type) { return type != Type::Group && type != Type::Any; }

Violation withText(const std::string &name, const std::string &text, const std::string &reason) {
    return {name, [text](tinyxml2::XMLElement &element) { element.SetText(text.c_str()); }, reason};
}

std::string write(double number) {
    std::ostringstream text;
    text.precision(17);
    text << number;
    return text.str();
}

// `first` in place of the first number.
std::string replaceFirst(const std::string &numbers, const std::string &first) {
    const std::size_t end = numbers.find(' ');
    return first + (end == std::string::npos ? "" : numbers.substr(end));
}

void addNumbers(const NamedRule &named, std::vector<Violation> &list) {
    const std::string good = rule_world::sample(named);
    const ElementRule &rule = named.rule;
    list.push_back(withText("a word", replaceFirst(good, "heavy"), "is not a number"));
    if (rule.type != Type::Mask) list.push_back(withText("hexadecimal", replaceFirst(good, "0x1"), "is not a number"));
    if (rule.type == Type::Mask) list.push_back(withText("too large", "0x10000", "is not between"));
    if (rule.type == Type::Mask) list.push_back(withText("no digits", "0xg", "is not a number"));
    list.push_back(withText("overflow", replaceFirst(good, "1e400"), "is not a number"));
    list.push_back(withText("NaN", replaceFirst(good, "nan"), "not a number"));
    list.push_back(withText("surplus", good + " 1", "numbers instead of"));
    list.push_back(withText("a unit", good + " kg", "is not a number"));
    if (rule.count > 1) list.push_back(withText("too few", "1", "has 1 numbers instead of"));
    list.push_back(withText("denormal", replaceFirst(good, "1e-310"), "too small"));
    if (rule.type != Type::Limit) {
        list.push_back(withText("infinite", replaceFirst(good, "inf"), "not finite"));
        list.push_back(withText("huge", replaceFirst(good, "1e300"), "not between"));
        list.push_back(withText("above", replaceFirst(good, write(std::nextafter(rule.most, 1e300) * 1.001)),
                                "between"));
    }
    if (rule.type == Type::Limit && std::isfinite(rule.most))
        list.push_back(withText("above", "inf", "up to"));
    if (std::isfinite(rule.least))
        list.push_back(withText("below",
                                replaceFirst(good, write(rule.least - 1e-3 * std::fabs(rule.least) - 1e-3)),
                                rule.type == Type::Limit ? "or more" : "between"));
    if (rule.type == Type::Whole || rule.type == Type::Mask) {
        list.push_back(withText("a fraction", "1.5", rule.most < 1.5 ? "between" : "is not a whole number"));
        list.push_back(withText("an exponent", "1e0", "is not a whole number"));
    }
    if (rule.type == Type::Direction) list.push_back(withText("zero", "0 0 0", "is no direction"));
}

void addPoses(std::vector<Violation> &list) {
    list.push_back(withText("five numbers", "0 0 0 0 0", "has 5 numbers instead of 6"));
    list.push_back(withText("seven numbers", "0 0 0 0 0 0 1", "has 7 numbers instead of 6"));
    list.push_back(withText("a word", "0 0 0 0 0 up", "is not a number"));
    list.push_back(withText("NaN", "0 0 0 0 0 nan", "not a number"));
    list.push_back(withText("huge", "1e300 0 0 0 0 0", "not between"));
    const auto quaternion = [&](const std::string &name, const std::string &text, const std::string &reason) {
        list.push_back({name,
                        [text](tinyxml2::XMLElement &pose) {
                            pose.SetAttribute("rotation_format", "quat_xyzw");
                            pose.SetText(text.c_str());
                        },
                        reason});
    };
    quaternion("zero quaternion", "0 0 0 0 0 0 0", "quaternion whose length is not 1");
    quaternion("long quaternion", "0 0 0 1 1 1 1", "quaternion whose length is not 1");
    quaternion("short quaternion", "0 0 0 0 0 1", "has 6 numbers instead of 7");
    list.push_back({"unknown format",
                    [](tinyxml2::XMLElement &pose) { pose.SetAttribute("rotation_format", "matrix"); },
                    "'matrix' is neither"});
    list.push_back({"degrees", [](tinyxml2::XMLElement &pose) { pose.SetAttribute("degrees", "maybe"); },
                    "'maybe' is neither"});
}

void addChildren(const ElementRule &rule, std::vector<Violation> &list) {
    for (const std::string &child : rule.needs)
        list.push_back({"without " + child,
                        [child](tinyxml2::XMLElement &element) {
                            element.DeleteChild(element.FirstChildElement(child.c_str()));
                        },
                        "needs an element <" + child + ">"});
    if (!rule.needsOneOf.empty())
        list.push_back({"without any", [](tinyxml2::XMLElement &element) { element.DeleteChildren(); },
                        "needs an element link"});
    if (rule.needsOneChild) {
        list.push_back({"without any", [](tinyxml2::XMLElement &element) { element.DeleteChildren(); },
                        "holds no element"});
        list.push_back({"with two",
                        [](tinyxml2::XMLElement &element) {
                            element.InsertNewChildElement("box")->InsertNewChildElement("size")->SetText(
                                "1 1 1");
                        },
                        "holds two elements, <sphere> and <box>"});
    }
    list.push_back({"with text",
                    [](tinyxml2::XMLElement &element) {
                        element.InsertEndChild(element.GetDocument()->NewText("stray"));
                    },
                    "holds text: 'stray'"});
}

void addDoubled(const NamedRule &named, std::vector<Violation> &list) {
    const auto again = [](tinyxml2::XMLElement &element) {
        tinyxml2::XMLNode *copy = element.DeepClone(element.GetDocument());
        element.Parent()->InsertAfterChild(&element, copy);
    };
    const std::string geometry = "collision/geometry/";  // its shapes are "two elements"
    const bool isShape = named.path.rfind('/') == geometry.size() - 1 && named.path.rfind(geometry, 0) == 0;
    // Of SDF's own elements the first one counts.
    const bool isRefused = named.path == "/sdf/world" || named.path.find("/odemt:") != std::string::npos;
    if (named.rule.often == worlds::Often::Once && named.path != "/sdf" && isRefused && !isShape) {
        list.push_back({"doubled", again, "is written twice"});
    } else if (named.path == "world/model" || named.path == "model/link" || named.path == "model/joint" ||
               named.path == "link/collision" || named.path == "model/frame") {
        list.push_back({"doubled", again, "a second <"});
    }
}

std::vector<Violation> violationsOf(const NamedRule &named) {
    std::vector<Violation> list;
    const ElementRule &rule = named.rule;
    if (isValue(rule.type)) {
        if (rule.type != Type::Pose) {  // an empty one is that of the frame that it is relative to
            list.push_back({"empty", [](tinyxml2::XMLElement &element) { element.DeleteChildren(); }, "is empty"});
            list.push_back(withText("blank", " \n ", "is empty"));
        }
        list.push_back({"holding an element",
                        [](tinyxml2::XMLElement &element) { element.InsertNewChildElement("extra"); },
                        "holds an element, <extra>"});
    }
    if (isNumber(rule.type)) addNumbers(named, list);
    if (rule.type == Type::Pose) addPoses(list);
    if (rule.type == Type::Choice) list.push_back(withText("unknown word", "other", "'other' is none of"));
    if (rule.type == Type::Flag) list.push_back(withText("no flag", "perhaps", "is neither true nor false"));
    if (rule.type == Type::Text)
        list.push_back(withText("long", std::string(30000, 'x'), "has 30000 characters, more than"));
    if (rule.type == Type::Group) addChildren(rule, list);
    addDoubled(named, list);
    list.push_back({"long attribute",
                    [](tinyxml2::XMLElement &element) {
                        element.SetAttribute("extra", std::string(30000, 'x').c_str());
                    },
                    "attribute 'extra' has 30000 characters"});
    return list;
}

class ElementRules : public testing::Test {
protected:
    ElementRules() { rule_world::writeFiles(folder.path("")); }

    std::string message(const std::string &text) const {
        try {
            worlds::loadWorldText(text, folder.path("test.sdf"));
        } catch (const worlds::LoadError &error) {
            return error.what();
        }
        return "loaded";
    }

    small_world::TestFolder folder{"element_rules"};
};

void expectStart(const std::string &message, const std::string &place, const std::string &reason) {
    EXPECT_EQ(message.find(place + ": "), 0u) << message << "\n  does not begin with\n" << place;
    EXPECT_NE(message.find(reason), std::string::npos) << message << "\n  does not say: " << reason;
}

template <class Visit>
void forEachRead(Visit visit) {
    for (const NamedRule &named : worlds::elementRules()) {
        if (named.rule.use != Use::Read) continue;
        SCOPED_TRACE(named.path);
        visit(named);
    }
}

TEST_F(ElementRules, KeptTheyLoadAndRun) {
    forEachRead([&](const NamedRule &named) {
        try {
            const auto scene = worlds::loadWorldText(RuleWorld(named).text(), folder.path("test.sdf"));
            small_world::run(*scene, 3);
        } catch (const worlds::LoadError &error) {
            ADD_FAILURE() << error.what() << "\n" << RuleWorld(named).text();
        }
    });
}

TEST_F(ElementRules, BrokenTheyNameFileElementAndReason) {
    std::size_t count = 0;
    forEachRead([&](const NamedRule &named) {
        for (const Violation &violation : violationsOf(named)) {
            SCOPED_TRACE(violation.name);
            RuleWorld world(named);
            violation.apply(*world.element);
            expectStart(message(world.text()), folder.path("test.sdf") + ": " + world.path, violation.reason);
            ++count;
        }
    });
    EXPECT_GT(count, 1000u);
}

// An element that may be written once, and is followed by another one, counts; a warning names it.
TEST_F(ElementRules, OfElementsWrittenTwiceTheFirstCounts) {
    std::size_t count = 0;
    forEachRead([&](const NamedRule &named) {
        const std::string geometry = "collision/geometry/";  // its shapes are "two elements"
        const bool isShape = named.path.rfind('/') == geometry.size() - 1 && named.path.rfind(geometry, 0) == 0;
        if (named.rule.often != worlds::Often::Once || named.path.rfind("/sdf", 0) == 0 || isShape ||
            named.path.find("/odemt:") != std::string::npos)
            return;
        RuleWorld world(named);
        // What the second one holds is not looked at.
        tinyxml2::XMLElement *second = world.xml.NewElement(world.element->Name());
        second->SetText("broken");
        world.element->Parent()->InsertAfterChild(world.element, second);
        std::vector<std::string> warnings;
        worlds::LoadOptions options;
        options.warnings = &warnings;
        EXPECT_NO_THROW(worlds::loadWorldText(world.text(), folder.path("test.sdf"), options)) << world.text();
        const std::string expected = folder.path("test.sdf") + ": " + world.path + ": is written twice: the first one counts, as in Gazebo";
        EXPECT_EQ(std::count(warnings.begin(), warnings.end(), expected), 1) << expected;
        ++count;
    });
    EXPECT_GT(count, 100u);
}

TEST_F(ElementRules, BrokenInIncludedFilesTheyNameThose) {
    const std::string file = folder.path("model.sdf");
    forEachRead([&](const NamedRule &named) {
        if (named.path == "world/model") return;
        for (const Violation &violation : violationsOf(named)) {
            SCOPED_TRACE(violation.name);
            RuleWorld world(named);
            violation.apply(*world.element);
            if (world.moveModelTo(file))
                expectStart(message(world.text()), file + ": " + world.path, violation.reason);
        }
    });
}

// Whatever the table allows is no danger: the ends of each range load, or are refused for a reason of
// their own, and the scene can run, with shapes that touch.
TEST_F(ElementRules, EndsOfRangesDoNotCrash) {
    forEachRead([&](const NamedRule &named) {
        if (!isNumber(named.rule.type) || named.rule.type == Type::Direction) return;
        for (const double end : {named.rule.least, named.rule.most}) {
            RuleWorld world(named);
            std::string text;
            for (int i = 0; i < named.rule.count; ++i) text += (i ? " " : "") + write(end);
            world.element->SetText(text.c_str());
            world.addCompany();
            SCOPED_TRACE(text);
            try {
                const auto scene = worlds::loadWorldText(world.text(), folder.path("test.sdf"));
                small_world::run(*scene, 20);
            } catch (const worlds::LoadError &error) {
                EXPECT_EQ(std::string(error.what()).find(folder.path("test.sdf") + ": /sdf/world/"), 0u)
                    << error.what();
            }
        }
    });
}

}  // namespace
