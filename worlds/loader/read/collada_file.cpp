#include "loader/read/collada_file.h"

#include "loader/load_error.h"
#include "loader/read/collada_mesh.h"
#include "loader/read/mesh_file.h"
#include "loader/read/word_list.h"
#include "loader/read/xml_text.h"
#include "support/text.h"

#include <cmath>
#include <map>
#include <set>

namespace worlds {

namespace {

using tinyxml2::XMLElement;

constexpr int deepestNode = 100;
constexpr std::size_t maxNodes = 100000, maxInstanceCorners = 100000000;  // instances written out

// How many numbers the elements hold that move what is in a node.
const std::map<std::string, int> &transforms() {
    static const std::map<std::string, int> numbers = {{"lookat", 9}, {"matrix", 16}, {"rotate", 4},
                                                       {"scale", 3},  {"skew", 7},    {"translate", 3}};
    return numbers;
}

// Elements of a node that contain no triangles.
bool isLeftOut(const std::string &kind) {
    static const std::set<std::string> kinds = {"asset", "extra", "instance_camera", "instance_light"};
    return kinds.count(kind) > 0;
}

class Reduction {
public:
    std::string reduce(const std::string &text) {
        if (const std::string wrong = readXml(text, m_xml); !wrong.empty()) throw MeshFault(wrong);
        const XMLElement &root = *m_xml.RootElement();
        if (std::string(root.Name()) != "COLLADA")
            throw MeshFault("is no COLLADA: the root element is <" + std::string(root.Name()) + ">");
        collect(root);
        XMLElement &out = *m_reduced.NewElement("COLLADA");
        m_reduced.InsertEndChild(&out);
        out.SetAttribute("xmlns", "http://www.collada.org/2005/11/COLLADASchema");
        out.SetAttribute("version", "1.4.1");
        unit(root, *out.InsertNewChildElement("asset"));
        m_geometries = out.InsertNewChildElement("library_geometries");
        XMLElement &scene =
            *out.InsertNewChildElement("library_visual_scenes")->InsertNewChildElement("visual_scene");
        scene.SetAttribute("id", "scene");
        const XMLElement &instance = requiredChild(requiredChild(root, "scene"), "instance_visual_scene");
        const XMLElement &shown = find(m_scenes, instance);
        for (const XMLElement *child = shown.FirstChildElement("node"); child;
             child = child->NextSiblingElement("node"))
            node(*child, scene, 1);
        out.InsertNewChildElement("scene")
            ->InsertNewChildElement("instance_visual_scene")
            ->SetAttribute("url", "#scene");
        tinyxml2::XMLPrinter printer(nullptr, true);
        m_reduced.Print(&printer);
        return printer.CStr();
    }

private:
    using ById = std::multimap<std::string, const XMLElement *>;

    static void add(ById &elements, const XMLElement &element) {
        if (const char *id = element.Attribute("id")) elements.emplace(id, &element);
    }

    void collect(const XMLElement &root) {
        const auto forEach = [&](const char *library, const char *kind, const auto &visit) {
            for (const XMLElement *all = root.FirstChildElement(library); all;
                 all = all->NextSiblingElement(library))
                for (const XMLElement *one = all->FirstChildElement(kind); one;
                     one = one->NextSiblingElement(kind))
                    visit(*one);
        };
        forEach("library_geometries", "geometry", [&](const XMLElement &one) { add(m_meshes, one); });
        forEach("library_nodes", "node", [&](const XMLElement &one) { collectNodes(one); });
        forEach("library_visual_scenes", "visual_scene", [&](const XMLElement &one) {
            add(m_scenes, one);
            for (const XMLElement *inner = one.FirstChildElement("node"); inner;
                 inner = inner->NextSiblingElement("node"))
                collectNodes(*inner);
        });
    }

    void collectNodes(const XMLElement &node) {
        add(m_nodes, node);
        for (const XMLElement *inner = node.FirstChildElement("node"); inner;
             inner = inner->NextSiblingElement("node"))
            collectNodes(*inner);
    }

    static const XMLElement &find(const ById &elements, const XMLElement &instance) {
        const std::string id = referenceOf(instance, "url");
        if (elements.count(id) != 1)
            fail(instance, "names " + support::quote(id) + ", of which there " +
                               (elements.count(id) ? "are several" : "is none"));
        return *elements.find(id)->second;
    }

    static void unit(const XMLElement &root, XMLElement &asset) {
        const XMLElement *const given = root.FirstChildElement("asset")
                                            ? root.FirstChildElement("asset")->FirstChildElement("unit")
                                            : nullptr;
        const char *const meter = given ? given->Attribute("meter") : nullptr;
        if (!meter) return;
        const std::optional<double> metres = finiteNumber(meter);
        if (!metres || *metres < 1e-9 || *metres > 1e9)
            fail(*given, "has " + support::quote(meter) + " as 'meter', not a number between 1e-9 and 1e9");
        asset.InsertNewChildElement("unit")->SetAttribute("meter", meter);
    }

    void node(const XMLElement &source, XMLElement &outer, int depth) {
        if (depth > deepestNode)
            fail(source, "is nested more than " + std::to_string(deepestNode) + " deep, or within itself");
        if (++m_nodeCount > maxNodes)
            throw MeshFault("shows more than " + std::to_string(maxNodes) + " nodes");
        if (isEmpty(source)) return;
        XMLElement &out = *outer.InsertNewChildElement("node");
        for (const XMLElement *child = source.FirstChildElement(); child;
             child = child->NextSiblingElement()) {
            const std::string kind = child->Name();
            if (kind == "node")
                node(*child, out, depth + 1);
            else if (kind == "instance_node")
                node(find(m_nodes, *child), out, depth + 1);
            else if (kind == "instance_geometry")
                geometry(*child, out);
            else if (transforms().count(kind))
                transform(*child, out);
            else if (!isLeftOut(kind))
                fail(*child, "is not supported");
        }
    }

    // A node of a camera or the like, whose transforms place nothing: SketchUp writes such ones with numbers of any kind.
    static bool isEmpty(const XMLElement &node) {
        for (const XMLElement *child = node.FirstChildElement(); child; child = child->NextSiblingElement())
            if (transforms().count(child->Name()) == 0 && !isLeftOut(child->Name())) return false;
        return true;
    }

    static void transform(const XMLElement &source, XMLElement &outer) {
        const std::string text = wholeText(source);
        int count = 0;
        WordList words(text);
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++count)
            if (const std::optional<double> number = finiteNumber(word); !number || std::fabs(*number) > 1e16)
                fail(source, "holds " + support::quote(std::string(word)) + ", not a number between -1e16 and 1e16");
        const int wanted = transforms().at(source.Name());
        if (count != wanted)
            fail(source, "has " + std::to_string(count) + " numbers instead of " + std::to_string(wanted));
        outer.InsertNewChildElement(source.Name())->SetText(text.c_str());
    }

    void geometry(const XMLElement &instance, XMLElement &outer) {
        const XMLElement &source = find(m_meshes, instance);
        const std::string id = source.Attribute("id");
        const auto known = m_corners.find(id);
        const std::size_t corners = known == m_corners.end() ? write(source, id) : known->second;
        m_instanceCorners += corners;
        if (m_instanceCorners > maxInstanceCorners)
            throw MeshFault("shows polygons of more than " + std::to_string(maxInstanceCorners) +
                            " corners");
        if (corners > 0)
            outer.InsertNewChildElement("instance_geometry")->SetAttribute("url", ("#" + id).c_str());
    }

    // Returns how many corners its polygons have.
    std::size_t write(const XMLElement &source, const std::string &id) {
        const ColladaMesh mesh = readColladaMesh(requiredChild(source, "mesh"));
        m_corners[id] = mesh.corners.size();
        if (mesh.corners.empty()) return 0;
        XMLElement &geometry = *m_geometries->InsertNewChildElement("geometry");
        geometry.SetAttribute("id", id.c_str());
        XMLElement &out = *geometry.InsertNewChildElement("mesh");
        XMLElement &positions = *out.InsertNewChildElement("source");
        positions.SetAttribute("id", (id + " positions").c_str());
        XMLElement &array = *positions.InsertNewChildElement("float_array");
        array.SetAttribute("id", (id + " numbers").c_str());
        array.SetAttribute("count", static_cast<std::uint64_t>(3 * mesh.vertexCount));
        array.SetText(mesh.positions.c_str());
        XMLElement &accessor =
            *positions.InsertNewChildElement("technique_common")->InsertNewChildElement("accessor");
        accessor.SetAttribute("source", ("#" + id + " numbers").c_str());
        accessor.SetAttribute("count", static_cast<std::uint64_t>(mesh.vertexCount));
        accessor.SetAttribute("stride", 3);
        for (const char *const axis : {"X", "Y", "Z"}) {
            XMLElement &param = *accessor.InsertNewChildElement("param");
            param.SetAttribute("name", axis);
            param.SetAttribute("type", "float");
        }
        XMLElement &vertices = *out.InsertNewChildElement("vertices");
        vertices.SetAttribute("id", (id + " vertices").c_str());
        input(vertices, "POSITION", id + " positions");
        XMLElement &polygons = *out.InsertNewChildElement("polylist");
        polygons.SetAttribute("count", static_cast<std::uint64_t>(mesh.sizes.size()));
        input(polygons, "VERTEX", id + " vertices").SetAttribute("offset", 0);
        polygons.InsertNewChildElement("vcount")->SetText(list(mesh.sizes).c_str());
        polygons.InsertNewChildElement("p")->SetText(list(mesh.corners).c_str());
        return mesh.corners.size();
    }

    static XMLElement &input(XMLElement &outer, const char *semantic, const std::string &source) {
        XMLElement &out = *outer.InsertNewChildElement("input");
        out.SetAttribute("semantic", semantic);
        out.SetAttribute("source", ("#" + source).c_str());
        return out;
    }

    template <class Numbers>
    static std::string list(const Numbers &numbers) {
        std::string text;
        for (const auto number : numbers) text.append(std::to_string(number)).append(" ");
        return text;
    }

    tinyxml2::XMLDocument m_xml, m_reduced;
    ById m_meshes, m_nodes, m_scenes;
    XMLElement *m_geometries = nullptr;
    std::map<std::string, std::size_t> m_corners;  // of geometries that are written
    std::size_t m_nodeCount = 0, m_instanceCorners = 0;
};

}  // namespace

std::string reduceCollada(const std::string &text) { return Reduction().reduce(text); }

}  // namespace worlds
