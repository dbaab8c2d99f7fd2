#include "random_sdf.h"

#include <algorithm>
#include <random>
#include <sstream>
#include <vector>

namespace small_world {

namespace {

class Writer {
public:
    Writer(std::uint32_t seed, int version, const TestFolder &folder)
        : m_random(seed), m_version(version), m_folder(folder) {}

    std::string world() {
        const std::string version = "<sdf version=\"1." + std::to_string(m_version) + "\">";
        std::vector<std::string> inside, frames;
        const std::string gravity = "<gravity>" + numbers(3, -10, 10) + "</gravity>";
        inside.push_back("<physics name=\"p\" type=\"ode\"><max_step_size>" + numbers(1, 0.001, 0.01) +
                         "</max_step_size>" + (m_version <= 5 ? gravity : "") + "<max_contacts>" +
                         std::to_string(1 + below(30)) + "</max_contacts><ode><solver><iters>" +
                         std::to_string(1 + below(99)) + "</iters><sor>" + numbers(1, 1, 1.9) +
                         "</sor></solver><constraints><cfm>" + numbers(1, 0, 1) + "</cfm><erp>" +
                         numbers(1, 0, 1) + "</erp></constraints></ode></physics>");
        if (m_version > 5) inside.push_back(gravity);
        for (std::size_t i = 1 + below(3); i > 0; --i) {
            if (m_version >= 7 && oneIn(2)) inside.push_back(frame(frames));
            inside.push_back(m_version >= 7 && oneIn(3) ? include("outermost", frames) : model(0, frames));
        }
        return version + "<world name=\"w\">" + shuffled(inside) + "</world></sdf>";
    }

private:
    std::size_t below(std::size_t end) { return m_random() % end; }
    bool oneIn(std::size_t count) { return below(count) == 0; }
    std::string newName(const std::string &kind) { return kind + std::to_string(m_names++); }
    const std::string &anyOf(const std::vector<std::string> &names) { return names[below(names.size())]; }

    std::string numbers(int count, double least, double most) {
        std::ostringstream text;
        text.precision(17);
        for (int i = 0; i < count; ++i)
            text << (i ? " " : "") << least + (most - least) * static_cast<double>(below(1000001)) / 1e6;
        return text.str();
    }

    std::string shuffled(std::vector<std::string> &elements) {
        std::shuffle(elements.begin(), elements.end(), m_random);
        std::string text;
        for (const std::string &element : elements) text += element + "\n";
        return text;
    }

    // A pose relative to one of `frames`, or to none; `isBare` leaves that to the element around.
    std::string pose(const std::vector<std::string> &frames, bool isBare = false) {
        std::string attributes, text = numbers(3, -2, 2) + " ";
        if (!isBare && m_version >= 5 && !frames.empty() && oneIn(2))
            attributes =
                std::string(m_version >= 7 ? " relative_to" : " frame") + "=\"" + anyOf(frames) + "\"";
        if (m_version >= 9 && oneIn(4)) {
            static const char *const kTurns[] = {"0.5 -0.5 0.5 0.5", "0 0.6 0 0.8", "0.64 0 0.48 -0.6",
                                                 "0 0 0 1"};
            return "<pose rotation_format=\"quat_xyzw\"" + attributes + ">" + text + kTurns[below(4)] +
                   "</pose>";
        }
        const bool isInDegrees = m_version >= 9 && oneIn(3);
        const double half = isInDegrees ? 180 : 3.14159;
        return std::string("<pose") + (isInDegrees ? " degrees=\"true\"" : "") + attributes + ">" + text +
               numbers(3, -half, half) + "</pose>";
    }
    std::string maybe(const std::string &element) { return oneIn(4) ? "" : element; }

    // Adds its name to `frames`.
    std::string frame(std::vector<std::string> &frames) {
        const std::string name = newName("f");
        const std::string attached =
            !frames.empty() && oneIn(2) ? " attached_to=\"" + anyOf(frames) + "\"" : "";
        const std::string text =
            "<frame name=\"" + name + "\"" + attached + ">" + maybe(pose(frames)) + "</frame>";
        frames.push_back(name);
        return text;
    }

    std::string link(const std::string &name, std::vector<std::string> &frames) {
        static const char *const kShapes[] = {"<box><size>1 2 3</size></box>",
                                              "<sphere><radius>0.5</radius></sphere>",
                                              "<cylinder><radius>0.2</radius><length>0.7</length></cylinder>",
                                              "<capsule><radius>0.1</radius><length>0.3</length></capsule>"};
        const std::size_t shapes = m_version >= 8 ? 4 : 3;
        std::string text = "<link name=\"" + name + "\">" + maybe(pose(frames));
        if (oneIn(2))
            text += "<inertial>" + maybe(pose({}, true)) + "<mass>" + numbers(1, 0.1, 9) +
                    "</mass><inertia><ixx>" + numbers(1, 2, 3) + "</ixx><iyy>" + numbers(1, 2, 3) +
                    "</iyy><izz>" + numbers(1, 2, 3) + "</izz><ixy>" + numbers(1, -0.3, 0.3) + "</ixy><ixz>" +
                    numbers(1, -0.3, 0.3) + "</ixz><iyz>" + numbers(1, -0.3, 0.3) +
                    "</iyz></inertia></inertial>";
        for (std::size_t i = below(3); i > 0; --i)
            text += "<collision name=\"" + newName("c") + "\">" + maybe(pose(frames)) + "<geometry>" +
                    kShapes[below(shapes)] + "</geometry></collision>";
        return text + "</link>";
    }

    std::string axis(const std::string &name, const std::vector<std::string> &frames) {
        const std::string expressed =
            m_version >= 7 && oneIn(2) ? " expressed_in=\"" + (oneIn(3) ? "__model__" : anyOf(frames)) + "\""
                                       : std::string();
        const std::string ofModel = (m_version == 5 || m_version == 6) && oneIn(2)
                                        ? "<use_parent_model_frame>" + std::string(oneIn(2) ? "true" : "0") +
                                              "</use_parent_model_frame>"
                                        : std::string();
        return "<" + name + "><xyz" + expressed + ">" + numbers(1, 0.1, 1) + " " + numbers(2, -1, 1) +
               "</xyz>" + ofModel +
               maybe("<limit><lower>" + numbers(1, -1, 0) + "</lower><upper>" + numbers(1, 0, 1) +
                     "</upper>" + maybe("<effort>" + numbers(1, -1, 9) + "</effort>") +
                     maybe("<velocity>" + numbers(1, -1, 9) + "</velocity>") + "</limit>") +
               maybe("<dynamics><damping>" + numbers(1, 0, 1) + "</damping><friction>" + numbers(1, 0, 1) +
                     "</friction></dynamics>") +
               "</" + name + ">";
    }

    // `bodies` and `models` are frames that move with different links each. (libsdformat does not find a
    // model that is a parent.)
    std::string joint(const std::vector<std::string> &bodies, const std::vector<std::string> &models,
                      const std::vector<std::string> &frames) {
        static const char *const kTypes[] = {"revolute", "prismatic", "universal",
                                             "ball",     "fixed",     "continuous"};
        const std::size_t type = below(m_version >= 7 ? 6 : 4), child = below(bodies.size());
        const bool isModel = !models.empty() && (bodies.size() < 2 || oneIn(2));
        const std::string parent = oneIn(3) ? "world" : bodies[(child + 1) % bodies.size()];
        std::string text = std::string("<joint name=\"") + newName("j") + "\" type=\"" + kTypes[type] +
                           "\"><parent>" + parent + "</parent><child>" +
                           (isModel ? models[0] : bodies[child]) + "</child>" + maybe(pose(frames));
        if (type < 3 || type == 5) text += axis("axis", frames);
        if (type == 2) text += "<axis2><xyz>-1 0.1 0.2</xyz></axis2>";
        return text + "</joint>";
    }

    // Adds the model's name to `outer`, and names of frames inside it. Models within are not static: of
    // those, libsdformat does not say what a joint is attached to.
    std::string model(int depth, std::vector<std::string> &outer, const std::string &given = {}) {
        const std::string name = given.empty() ? newName("m") : given;
        std::vector<std::string> inside, frames, bodies, models;
        const bool hasScopes = m_version >= 8;
        for (std::size_t i = 1 + below(3); i > 0; --i) {
            const std::string own = newName("l");
            inside.push_back(link(own, frames));
            frames.push_back(own);
            bodies.push_back(own);
            if (m_version >= 7 && oneIn(2)) inside.push_back(frame(frames));
        }
        if (depth < 2 && m_version >= 7 && oneIn(2)) {
            std::vector<std::string> nested = frames;
            const std::size_t own =
                nested.size();  // where the model's name will be: it moves with its canonical link
            inside.push_back(oneIn(2) ? model(depth + 1, nested) : include("model", nested));
            if (hasScopes && oneIn(2)) models.push_back(nested[own]);
            if (hasScopes && models.empty()) bodies.push_back(nested.back());
            frames = hasScopes ? nested : frames;
        }
        if (m_version >= 9 && depth < 2 && oneIn(2)) inside.push_back(include("merged", frames));
        if (bodies.size() > 1 || !models.empty())
            for (std::size_t i = 1 + below(3); i > 0; --i) inside.push_back(joint(bodies, models, frames));
        std::string attributes;
        if (hasScopes && oneIn(3)) attributes += " placement_frame=\"" + anyOf(frames) + "\"";
        if (m_version >= 7 && oneIn(3)) attributes += " canonical_link=\"" + bodies.front() + "\"";
        const std::string text = "<model name=\"" + name + "\"" + attributes + ">" + maybe(pose(outer)) +
                                 (depth == 0 && oneIn(5) ? "<static>true</static>" : "") + shuffled(inside) +
                                 "</model>";
        if (m_version >= 7) outer.push_back(name);
        if (hasScopes) outer.push_back(name + "::" + anyOf(frames));
        if (hasScopes)
            outer.push_back(name + "::" + bodies.front());  // the last one moves with a link of its own
        return text;
    }

    // A model in a file of its own. A merged one adds nothing to `outer`.
    std::string include(const std::string &kind, std::vector<std::string> &outer) {
        const bool isMerged = kind == "merged";
        const std::string file = newName("part") + ".sdf", own = newName("m");
        std::vector<std::string> inside;  // frames around the model are not its file's to know
        const std::string text = model(2, inside, own);
        m_folder.write(file, "<sdf version=\"1." + std::to_string(m_version) + "\">" + text + "</sdf>");
        const std::string name = oneIn(2) ? newName("n") : own;
        std::string more = name == own ? "" : "<name>" + name + "</name>";
        if (oneIn(2)) {
            more += pose(isMerged ? std::vector<std::string>() : outer);
            if (m_version >= 8 && oneIn(2))
                more += "<placement_frame>" + inside.back().substr(own.size() + 2) + "</placement_frame>";
        }
        if (kind == "outermost" && oneIn(4))
            more += "<static>" + std::string(oneIn(2) ? "true" : "false") + "</static>";
        if (!isMerged) {
            outer.push_back(name);
            if (m_version >= 8) outer.push_back(name + inside.back().substr(own.size()));
        }
        return "<include" + std::string(isMerged ? " merge=\"true\"" : "") + "><uri>" + file + "</uri>" +
               more + "</include>";
    }

    std::mt19937 m_random;
    int m_version;
    const TestFolder &m_folder;
    int m_names = 0;
};

}  // namespace

std::string randomSdf(std::uint32_t seed, int version, const TestFolder &folder) {
    return Writer(seed, version, folder).world();
}

}  // namespace small_world
